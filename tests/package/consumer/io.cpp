// Prints the type of the file that it is given.
#include <files/format.h>

#include <iostream>

int main(int count, char** arguments) {
    if (count != 2) {
        return 1;
    }
    const auto format = suture::io::format_of_content(arguments[1]);
    std::cout << (format ? suture::io::to_string(*format) : format.error().message) << '\n';
}
