// A part that Suture has closed, worked on in OpenSCAD (docs/openscad.md).
//
//     suture fill box_without_lid.step -o box.off --deflection 0.02
//     openscad -D 'part="box.off"' -o engraved.stl suture.scad

part = "box.off";
engraving = 1;  // mm deep
size = [60, 40, 30];  // of the part

difference() {
    import(part, convexity = 10);
    translate([size.x / 2, size.y / 2, size.z - engraving])
        cylinder(d = size.y / 2, h = 2 * engraving, $fn = 96);
}
