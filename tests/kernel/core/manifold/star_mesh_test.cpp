#include "suture/fill/manifold/star_mesh.h"

#include "kernel/core/manifold/support.h"

#include <algorithm>
#include <map>

namespace suture::manifold {
namespace {

using test::make_star;
using test::uneven;

/// The control mesh of a star: its charts' control points and quads, numbered at random.
PolygonMesh mesh_of(const Star& star, bool turned, unsigned seed = 11) {
    const Eigen::Matrix3Xd points = test::rough_points(star);
    std::vector<int> number(static_cast<std::size_t>(star.count()));
    for (std::size_t k = 0; k < number.size(); ++k) {
        number[k] = static_cast<int>(k);
    }
    std::mt19937 random(seed);
    std::shuffle(number.begin(), number.end(), random);
    PolygonMesh mesh;
    mesh.vertices.resize(3, star.count());
    for (int point = 0; point < star.count(); ++point) {
        mesh.vertices.col(number[static_cast<std::size_t>(point)]) = points.col(point);
    }
    std::map<std::vector<int>, bool> seen;
    for (int m = 0; m < star.n(); ++m) {
        for (int j = 0; j + 1 < star.charts_y(m); ++j) {
            for (int i = 0; i + 1 < star.charts_x(); ++i) {
                std::vector<int> face;
                for (const auto& [a, b] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
                    face.push_back(
                        number[static_cast<std::size_t>(star.point_of(m, i + a, j + b))]);
                }
                std::vector<int> key = face;
                std::sort(key.begin(), key.end());
                if (seen.emplace(key, true).second) {
                    std::rotate(face.begin(), face.begin() + (i + j) % 4, face.end());
                    if (turned) {
                        std::reverse(face.begin(), face.end());
                    }
                    mesh.faces.push_back(face);
                }
            }
        }
    }
    std::shuffle(mesh.faces.begin(), mesh.faces.end(), random);
    return mesh;
}

std::string refusal(const PolygonMesh& mesh) {
    const auto star = recognise_star(mesh);
    return star ? "" : star.error().message;
}

TEST(ManifoldStarMesh, FindsTheSidesOfAShuffledMesh) {
    for (const int n : {3, 4, 5, 7}) {
        for (int k = 0; k <= 4; ++k) {
            for (const bool turned : {false, true}) {
                const Star star = make_star(uneven(k, n));
                const auto found = recognise_star(mesh_of(star, turned));
                ASSERT_TRUE(found) << found.error().message;
                const StarSize size = found->size(k, star.aperture());
                EXPECT_EQ(size.layers, star.layers());
                std::vector<int> columns = size.columns;
                std::vector<int> expected;
                for (int m = 0; m < n; ++m) {
                    expected.push_back(star.columns(m));
                }
                if (turned) {
                    std::reverse(expected.begin(), expected.end());
                }
                bool same = false;
                for (int turn = 0; turn < n; ++turn) {
                    same = same || columns == expected;
                    std::rotate(columns.begin(), columns.begin() + 1, columns.end());
                }
                EXPECT_TRUE(same);
                // The same surface, turned about O.
                const Star again = make_star(size);
                const StarSurface a(star, test::rough_points(star));
                const StarSurface b(again, found->points(again));
                EXPECT_LT((a.at({0.0, 0.0}) - b.at({0.0, 0.0})).norm(), 1e-12);
            }
        }
    }
}

TEST(ManifoldStarMesh, TakesAPolygonInTheHole) {
    const Star star = make_star(uneven(2, 5));
    PolygonMesh mesh = mesh_of(star, false);
    const auto open = recognise_star(mesh);
    ASSERT_TRUE(open);
    std::vector<int> hole;
    for (int m = 0; m < 5; ++m) {
        const int width = star.charts_x();
        for (int j = 0; j < open->columns[static_cast<std::size_t>(m)]; ++j) {
            hole.push_back(open->grids[static_cast<std::size_t>(m)]
                                      [static_cast<std::size_t>(width * (width - 1 + j))]);
        }
    }
    mesh.faces.push_back(hole);
    EXPECT_EQ(refusal(mesh), "");
}

TEST(ManifoldStarMesh, SaysWhatIsWrongWithAMesh) {
    const PolygonMesh good = mesh_of(make_star(uneven(2, 5)), false);
    PolygonMesh mesh = good;
    mesh.faces.erase(mesh.faces.begin() + 7);
    EXPECT_NE(refusal(mesh), "");
    mesh = good;
    std::reverse(mesh.faces[3].begin(), mesh.faces[3].end());
    EXPECT_NE(refusal(mesh).find("same sense"), std::string::npos) << refusal(mesh);
    mesh = good;
    mesh.faces[5] = {mesh.faces[5][0], mesh.faces[5][1], mesh.faces[5][2]};
    mesh.faces[6] = {mesh.faces[6][0], mesh.faces[6][1], mesh.faces[6][2]};
    EXPECT_NE(refusal(mesh).find("sides"), std::string::npos) << refusal(mesh);
    // A plain grid has no hole.
    PolygonMesh grid;
    grid.vertices = Eigen::Matrix3Xd::Zero(3, 12);
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 3; ++i) {
            const int a = i + 4 * j;
            grid.faces.push_back({a, a + 1, a + 5, a + 4});
        }
    }
    EXPECT_NE(refusal(grid).find("1 borders"), std::string::npos) << refusal(grid);
    // A tube has no corners: vertices of valence 2 and 4 at its borders.
    PolygonMesh tube;
    tube.vertices = Eigen::Matrix3Xd::Zero(3, 15);
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 5; ++i) {
            tube.faces.push_back(
                {i + 5 * j, (i + 1) % 5 + 5 * j, (i + 1) % 5 + 5 * j + 5, i + 5 * j + 5});
        }
    }
    EXPECT_NE(refusal(tube).find("0 corners"), std::string::npos) << refusal(tube);
}

TEST(ManifoldStarMesh, NamesTheVertexOfAWrongValence) {
    // Three quads around a vertex inside.
    PolygonMesh mesh;
    mesh.vertices = Eigen::Matrix3Xd::Zero(3, 7);
    mesh.faces = {{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 1}};
    EXPECT_NE(refusal(mesh), "");
    const Star star = make_star(uneven(2, 5));
    mesh = mesh_of(star, false);
    // One more face at the outer border makes a corner there.
    const auto found = recognise_star(mesh);
    ASSERT_TRUE(found);
    const auto& grid = found->grids[0];
    const int width = star.charts_x();
    const int a = grid[static_cast<std::size_t>(width - 1 + width * 4)];
    const int b = grid[static_cast<std::size_t>(width - 1 + width * 5)];
    const auto first = static_cast<int>(mesh.vertices.cols());
    mesh.vertices.conservativeResize(3, first + 2);
    mesh.vertices.rightCols(2).setZero();
    mesh.faces.push_back({a, first, first + 1, b});
    const std::string said = refusal(mesh);
    EXPECT_NE(said.find("has valence 4"), std::string::npos) << said;
    EXPECT_TRUE(said.find("vertex " + std::to_string(a + 1)) != std::string::npos ||
                said.find("vertex " + std::to_string(b + 1)) != std::string::npos)
        << said;
}

}  // namespace
}  // namespace suture::manifold
