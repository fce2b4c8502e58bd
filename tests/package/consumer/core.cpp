// Prints the ids of the fill methods.
#include <suture/fill/fill.h>

#include <iostream>

int main() {
    for (const suture::FillMethod& method : suture::fill_methods()) {
        std::cout << method.id << '\n';
    }
}
