// Prints the type of the file that it is given, and how many parts the model has.
#include <files/format.h>
#include <files/read.h>

#include <iostream>

int main(int count, char** arguments) {
    if (count != 2) {
        return 1;
    }
    const auto format = suture::io::format_of_content(arguments[1]);
    std::cout << (format ? suture::io::to_string(*format) : format.error().message) << '\n';
    const auto model = suture::io::read_model(arguments[1], {});
    std::cout << (model ? std::to_string(model->parts().size()) : model.error().message) << '\n';
}
