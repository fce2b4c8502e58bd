// Prints what the kernel measures of a box of 1 x 2 x 3.
#include <suture/check/validity.h>

#include <BRepPrimAPI_MakeBox.hxx>

#include <iostream>

int main() {
    const suture::Validity box =
        suture::measure_validity(BRepPrimAPI_MakeBox(1.0, 2.0, 3.0).Solid());
    std::cout << box.valid << ' ' << box.solids << ' ' << box.faces << ' ' << box.free_edges << ' '
              << box.volume.value_or(0.0) << '\n';
}
