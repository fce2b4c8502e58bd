// The readers that are Suture's own; what OCCT reads is read in a process of its own.
#include "cli/algebraic_problem.h"
#include "cli/points_file.h"
#include "cli/profile_file.h"
#include "files/brep.h"
#include "files/format.h"
#include "files/read_obj.h"
#include "files/step_faces.h"
#include "files/step_scan.h"
#include "suture/fill/algebraic/parse.h"
#include "suture/occ/guard.h"

#include "fuzz/targets/target.h"
#include <unistd.h>

#include <BRepPrimAPI_MakeBox.hxx>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace suture::fuzz {

namespace {

namespace fs = std::filesystem;

constexpr const char* kStep =
    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nENDSEC;\nDATA;\n"
    "#1=CARTESIAN_POINT('a''b',(0.,1.E1,-2.));/* c #9 ; */\n#2=ADVANCED_FACE('',(#3),#4,.T.);\n"
    "#3=FACE_BOUND('',#5,.T.);\n#4=PLANE('',#1);\n#5=EDGE_LOOP('',(#1));\nENDSEC;\n"
    "END-ISO-10303-21;\n";

constexpr const char* kProblem =
    R"({"k": 1, "centre": [1, 1, 1], "sides": [
    {"surface": "10yz - 25z^2 + 40z - y^2", "plane": "y - 1", "from": [0, 1, 1]},
    {"surface": "(x - 1)^2 + (y - 1)^2 - 1", "plane": "z - 1", "from": [1, 0, 1]}]})";

/// A file that holds the bytes, for readers that open their input themselves.
class TemporaryFile {
  public:
    explicit TemporaryFile(std::string_view bytes)
        : path_(fs::temp_directory_path() / ("suture-fuzz-" + std::to_string(getpid()))) {
        std::ofstream(path_, std::ios::binary)
            .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        std::error_code ignored;
        fs::remove(path_, ignored);
    }
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

/// One line that says something.
template <class T>
void expect_told(const Result<T>& result) {
    if (!result && (result.error().message.empty() ||
                    result.error().message.find('\n') != std::string::npos)) {
        broken("an error is one line: " + result.error().message);
    }
}

/// Counts, and that all offsets lie in the text and rise.
struct Walk {
    std::size_t size = 0, last = 0;

    void go_to(std::size_t at) {
        if (at > size || at < last) {
            broken("offsets rise and lie in the text");
        }
        last = at;
    }
    void defines(io::StepId, std::size_t at) { go_to(at); }
    void refers(io::StepId) {}
    void ends(std::size_t at) { go_to(at); }
    bool keyword(std::string_view) { return true; }
    void text(std::size_t from, std::size_t to) {
        go_to(from);
        go_to(to);
    }
};

void step_scan(std::string_view bytes) {
    Walk walk{bytes.size()};
    io::StepScanner<Walk>(bytes, walk).scan();
}

void step_part(std::string_view bytes) {
    const std::size_t all = bytes.empty() ? 0 : static_cast<std::size_t>(bytes[0] % 3);
    expect_told(io::extract_step_faces(bytes, {{2}}, all));
    expect_told(io::extract_step_faces(bytes, {{2}, {2, 7}}, 1));
}

void format(std::string_view bytes) {
    expect_told(io::format_of_bytes(bytes, "input"));
}

void obj(std::string_view bytes) {
    const TemporaryFile file(bytes);
    expect_told(io::read_obj(file.path()));
}

void points(std::string_view bytes) {
    const TemporaryFile file(bytes);
    const auto read = cli::read_points(file.path());
    expect_told(read);
    for (const ThroughPoint& point : read ? *read : std::vector<ThroughPoint>{}) {
        if (!point.point.allFinite() || (point.normal && !point.normal->allFinite())) {
            broken("points and normals are finite");
        }
    }
}

void profile(std::string_view bytes) {
    const TemporaryFile file(bytes);
    const auto read = cli::read_profile(file.path());
    expect_told(read);
    if (read && !(read->tolerance.linear > 0.0 && std::isfinite(read->tolerance.linear))) {
        broken("limits are positive and finite");
    }
}

void problem(std::string_view bytes) {
    const TemporaryFile file(bytes);
    expect_told(cli::read_problem(file.path()));
}

void polynomial(std::string_view bytes) {
    expect_told(algebraic::parse_polynomial(bytes));
}

/// What follows after the shapes: OCCT's ending, FreeCAD's, or neither.
void brep_ending(std::string_view bytes) {
    static const std::string whole = [] {
        std::ostringstream stream;
        (void)io::write_brep_freecad(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), stream);
        return stream.str();
    }();
    constexpr std::size_t kEnding = 32;
    const std::string file = whole.substr(0, whole.size() - kEnding) + std::string(bytes);
    expect_told(occ::guarded("reading", [&] { return io::read_brep_binary(file, "input.bin"); }));
}

}  // namespace

std::vector<Target> reader_targets() {
    return {
        {"step_scan", step_scan, {kStep}},
        {"step_part", step_part, {kStep}},
        {"format", format, {kStep, "DBRep_DrawableShape\n", "solid a\n", "{}", "PK\3\4"}},
        {"obj",
         obj,
         {"v 0 0 0\nv 1 0 0\nv 1 1 .5\nv 0 1 0\nf 1 2 3 4\n", "v 1 2 3 # c\nf -1 -1 -1"}},
        {"points", points, {"x,y,z\n10,10,25\n20 20 24\n30;15;25\n# no point\n", "1 2 3 0 0 1\n"}},
        {"profile",
         profile,
         {R"({"name": "a", "g0_mm": 0.01, "g1_deg": 0.1, "g2_percent": 5, "g2_by": "sum"})"}},
        {"problem", problem, {kProblem}},
        {"polynomial", polynomial, {"x^2+2/3*y*z-(x+1)^3*0.5e-1", "-((x))"}},
        {"brep_ending", brep_ending, {std::string(32, '\0'), std::string("\1\0\0\0\1\1\1", 7)}},
    };
}

}  // namespace suture::fuzz
