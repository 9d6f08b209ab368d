// Tests app/importer/files/Rounding.cpp and app/importer/files/AssimpValues.cpp.
#include "core/asset/import/AssetImport.h"
#include "core/base/Random.h"
#include "core/geometry/mesh/SolidMesh.h"
#include "core/io/mesh/MeshImport.h"
#include "core/io/text/Base64.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/Solids.h"

#include <QTemporaryDir>
#include <QTest>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

using namespace rubble;

namespace {

/// How programs write numbers: Blender and Maya, 3ds Max, MeshLab, Rhino and CloudCompare, in this order.
enum class Digits { Fixed, FixedWithoutZeros, Significant, Whole, Exponent };

struct RoundedFile {
    std::string name;
    std::string bytes;
    TriangleMesh mesh;  // as it is written
    std::string what;   // for messages
};

std::string textOf(double number, Digits digits, int decimals) {
    std::array<char, 64> text{};
    const auto print = [&](const char* format, int count) {
        std::snprintf(text.data(), text.size(), format, count, number);
    };
    switch (digits) {
        case Digits::Fixed:
        case Digits::FixedWithoutZeros: print("%.*f", decimals); break;
        case Digits::Significant: print("%.*g", decimals + 1); break;
        case Digits::Whole: return std::to_string(std::llround(number * std::pow(10.0, std::min(decimals, 3))));
        case Digits::Exponent: print("%.*e", decimals); break;
    }
    std::string result = text.data();
    if (digits != Digits::FixedWithoutZeros || result.find('.') == std::string::npos) return result;
    result.erase(result.find_last_not_of('0') + 1);
    if (result.ends_with('.')) result.pop_back();
    return result;
}

/// Three coordinates as text; those of `point` become what was written.
std::string pointText(Vec3& point, Digits digits, int decimals) {
    std::string line;
    for (int k = 0; k < 3; ++k) {
        const std::string number = textOf(point[k], digits, decimals);
        point[k] = std::stod(number);
        line += " " + number;
    }
    return line;
}

RoundedFile objOf(TriangleMesh mesh, Digits digits, int decimals) {
    constexpr std::array kStarts = {"# Blender 4.2\no part\n", "# 3ds Max\r\ng part\r\n", "# MeshLab\n",
                                    "# Rhino\no part\n", "o part\n"};
    std::string text = kStarts[static_cast<std::size_t>(digits)];
    for (Vec3& point : mesh.points) {
        text += "v" + pointText(point, digits, decimals);
        text += digits == Digits::Significant ? " 0.5 0.5 0.5\n" : "\n";
    }
    for (const auto& [a, b, c] : mesh.triangles)
        text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " + std::to_string(c + 1) + "\n";
    return {"part.obj", text, mesh, {}};
}

RoundedFile plyOf(TriangleMesh mesh, Digits digits, int decimals) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(mesh.points.size()) +
                       "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                       std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
    for (Vec3& point : mesh.points) text += pointText(point, digits, decimals).substr(1) + "\n";
    for (const auto& [a, b, c] : mesh.triangles)
        text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
    return {"part.ply", text, mesh, {}};
}

RoundedFile stlOf(TriangleMesh mesh, Digits digits, int decimals) {
    std::vector<std::string> lines;
    for (Vec3& point : mesh.points) lines.push_back("vertex" + pointText(point, digits, decimals) + "\n");
    std::string text = "solid part\n";
    for (const auto& triangle : mesh.triangles) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const std::uint32_t corner : triangle) text += lines[corner];
        text += "endloop\nendfacet\n";
    }
    return {"part.stl", text + "endsolid part\n", mesh, {}};
}

/// How integers stand for positions.
enum class Integers { Unsigned, Signed, Plain, Shifted, Repeated };

template <class Number>
void append(std::string& bytes, Number number) {
    std::array<char, sizeof number> copy;
    std::memcpy(copy.data(), &number, sizeof number);
    bytes.append(copy.begin(), copy.end());
}

constexpr bool hasSign(Integers integers) { return integers != Integers::Unsigned && integers != Integers::Plain; }

/// How many of the bits of integers with 16 bits are used, and how many stand for a size.
int storageBits(Integers integers) { return hasSign(integers) ? 15 : 16; }
int usedBits(Integers integers, int bits) { return hasSign(integers) ? bits - 1 : bits; }

/// The integer that stands for a fraction of the size, in [0, 1] or [-1, 1].
int integerOf(double fraction, Integers integers, int bits) {
    const int storage = storageBits(integers), used = usedBits(integers, bits), low = storage - used;
    const double most = std::ldexp(1.0, storage) - 1.0, mostUsed = std::ldexp(1.0, used) - 1.0;
    const int upper = static_cast<int>(std::lround(std::abs(fraction) * mostUsed));
    int whole = static_cast<int>(std::lround(upper * most / mostUsed));
    if (integers == Integers::Plain) whole = upper;
    if (integers == Integers::Shifted) whole = upper << low;
    if (integers == Integers::Repeated && used >= low) whole = upper << low | upper >> (used - low);
    return fraction < 0.0 ? -whole : whole;
}

RoundedFile gltfOf(TriangleMesh mesh, Integers integers, int bits) {
    const Box3 box = boundsOf(mesh);
    const double extent = std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
    const Vec3 origin = hasSign(integers) ? (box.min + box.max) / 2.0 : box.min;
    const double size = hasSign(integers) ? extent / 2.0 : extent;
    // What a number in the file stands for, and the scale of the node.
    const double step = size / integerOf(1.0, integers, bits);
    const double scale = integers == Integers::Plain ? step : step * (std::ldexp(1.0, storageBits(integers)) - 1.0);
    std::string data;
    for (Vec3& point : mesh.points) {
        for (int k = 0; k < 3; ++k) {
            const int whole = integerOf((point[k] - origin[k]) / size, integers, bits);
            append(data, static_cast<std::uint16_t>(whole));
            point[k] = origin[k] + step * whole;
        }
        append(data, std::uint16_t{0});
    }
    const std::size_t points = data.size();
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle) append(data, corner);
    const auto number = [](auto value) { return std::to_string(value); };
    const auto exact = [](double value) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), "%.17g", value);
        return std::string(text.data());
    };
    const std::string normalized = integers == Integers::Plain ? "" : R"(,"normalized":true)";
    return {
        "part.gltf",
        R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"part","mesh":0,"scale":[)" +
            exact(scale) + "," + exact(scale) + "," + exact(scale) + R"(],"translation":[)" + exact(origin.x) + "," +
            exact(origin.y) + "," + exact(origin.z) +
            R"(]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[)" +
            R"({"bufferView":0,"componentType":)" + (hasSign(integers) ? "5122" : "5123") + normalized +
            R"(,"type":"VEC3","count":)" + number(mesh.points.size()) +
            R"(},{"bufferView":1,"componentType":5125,"type":"SCALAR","count":)" + number(3 * mesh.triangles.size()) +
            R"(}],"bufferViews":[{"buffer":0,"byteStride":8,"byteLength":)" + number(points) +
            R"(},{"buffer":0,"byteOffset":)" + number(points) + R"(,"byteLength":)" + number(data.size() - points) +
            R"(}],"buffers":[{"byteLength":)" + number(data.size()) +
            R"(,"uri":"data:application/octet-stream;base64,)" + base64(data) + R"("}]})",
        mesh,
        {}};
}

Ring circle(std::uint32_t corners, double radius) { return star(corners, radius, radius); }

/// A convex, concave or ring-shaped outline about 2 m wide, scaled along x and y.
Polygon randomOutline(Random& random) {
    Polygon polygon;
    switch (random.below(6)) {
        case 0: polygon = {rectangle({0, 0}, {2, random.between(0.2, 2.0)}), {}}; break;
        case 1: polygon = {circle(3 + static_cast<std::uint32_t>(random.below(30)), 1.0), {}}; break;
        case 2: polygon = lShape(); break;
        case 3:
            polygon = {{{0, 0}, {2, 0}, {2, 1.5}, {1.6, 1.5}, {1.6, 0.4}, {0.4, 0.4}, {0.4, 1.5}, {0, 1.5}}, {}};
            break;
        case 4: polygon = lShapeWithHole(); break;
        default: polygon = {circle(16, 1.0), {reversed(circle(5, 0.5))}}; break;
    }
    const Vec2 scale(random.between(0.5, 2.0), random.between(0.5, 2.0));
    for (Vec2& corner : polygon.outer) corner *= scale;
    for (Ring& hole : polygon.holes)
        for (Vec2& corner : hole) corner *= scale;
    return polygon;
}

/// A prism of some decimetres to 20 m, rotated about the vertical or in any direction. Sets its smallest extent.
TriangleMesh randomPrism(Random& random, double& thickness) {
    const double depth = random.below(2) == 0 ? random.between(0.05, 0.3) : random.between(0.5, 4.0);
    const Polygon outline = randomOutline(random);
    TriangleMesh mesh = prismSolid(outline, depth);
    const double size = std::pow(10.0, random.between(-1.0, 0.6));
    const Vec2 extent = boundsOf(outline.outer).size();
    thickness = size * std::min({depth, extent.x, extent.y});
    for (Vec3& point : mesh.points) point *= size;
    Quat turn(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    if (random.below(3) == 0) turn.x = turn.z = 0.0;
    return placed(mesh, {{random.between(-9, 9), random.between(-9, 9), random.between(-9, 9)}, glm::normalize(turn)});
}

/// The files of a mesh: three text formats in five dialects with 2 to 6 decimals, and five kinds of glTF with 8 to 16
/// bits.
constexpr int kTextFiles = 3 * 5 * 5, kFiles = kTextFiles + 5 * 9;

RoundedFile roundedFile(const TriangleMesh& mesh, int number) {
    const bool isGltf = number >= kTextFiles;
    const int rest = isGltf ? number - kTextFiles : number % 25;
    const int dialect = isGltf ? rest / 9 : rest / 5, digits = isGltf ? 8 + rest % 9 : 2 + rest % 5;
    RoundedFile file = isGltf        ? gltfOf(mesh, static_cast<Integers>(dialect), digits)
                       : number < 25 ? objOf(mesh, static_cast<Digits>(dialect), digits)
                       : number < 50 ? plyOf(mesh, static_cast<Digits>(dialect), digits)
                                     : stlOf(mesh, static_cast<Digits>(dialect), digits);
    file.what = file.name + " in dialect " + std::to_string(dialect) + " with " + std::to_string(digits) + " digits";
    return file;
}

Result<SourceScene> imported(const RoundedFile& file) {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath(QString::fromStdString(file.name)).toStdString();
    std::ofstream(path, std::ios::binary) << file.bytes;
    return importMesh(path, RUBBLE_IMPORTER, {});
}

/// The most by which points are displaced in a file whose unit has so many metres, m.
double displacementIn(const RoundedFile& file, const TriangleMesh& mesh, double unit) {
    double farthest = 0.0;
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        farthest = std::max(farthest, glm::distance(mesh.points[i], unit * file.mesh.points[i]));
    return farthest;
}

struct Counts {
    int read = 0, fitted = 0, refused = 0;
    double largestError = 0.0;  // of fitted prisms, relative to the volume before rounding
};

/// Imports a file: read with its volume, or refused without advice that changes it.
QString faultOf(const TriangleMesh& mesh, double thickness, const RoundedFile& file, Counts& counts) {
    const auto fault = [&](const std::string& what) { return QString::fromStdString(file.what + ": " + what); };
    const Result<SourceScene> scene = imported(file);
    if (!scene) return fault(scene.error().message);
    const double scale = boundsOf(file.mesh).diagonal() / boundsOf(mesh).diagonal();
    const double unit = std::pow(10.0, -std::round(std::log10(scale)));
    const double volume = std::abs(signedVolume(file.mesh)) * unit * unit * unit;
    const double rounding = scene->objects[0].rounding * unit;
    if (displacementIn(file, mesh, unit) > 1.001 * rounding) return fault("the rounding is not seen");
    const ImportOptions options{.metresPerUnit = unit, .as = ImportShape::Prism, .findsFallbacks = true};
    const Result<ImportOutcome> outcome = importedInto({}, *scene, "part", options, {});
    if (!outcome) return fault(outcome.error().message);
    if (outcome->rejected.empty()) {
        if (outcome->assets.size() != 1) return fault("it is in parts");
        const double found = volumeOf(*outcome->assets[0].prism);
        if (std::abs(found - volume) > 1e-3 * volume)
            return fault(std::to_string(found) + " m³ in place of " + std::to_string(volume));
        ++counts.read;
        if (!outcome->assets[0].notes[0].starts_with("The file rounds points")) return {};
        ++counts.fitted;
        const double whole = std::abs(signedVolume(mesh));
        counts.largestError = std::max(counts.largestError, std::abs(found - whole) / whole);
        return {};
    }
    ++counts.refused;
    const RejectedObject& rejected = outcome->rejected[0];
    if (rounding < 0.008 * thickness) return fault("refused: " + rejected.error.message);
    for (const WorkingFallback& working : rejected.fallbacks)
        if (!rejected.isReshapedBy(working) && std::abs(working.volume - volume) > 0.0101 * volume)
            return fault("the fallback has " + std::to_string(working.volume) + " m³");
    return {};
}

}  // namespace

class RoundingTest : public QObject {
    Q_OBJECT
private slots:
    /// A file of each of 400 prisms; if RUBBLE_LONG is set, all files of 300.
    void roundedPrismsKeepTheirVolume() {
        const bool isLong = qEnvironmentVariableIsSet("RUBBLE_LONG");
        const std::uint64_t seeds = isLong ? 300 : 400;
        Counts counts;
        for (std::uint64_t seed = 0; seed < seeds; ++seed) {
            Random random(seed);
            double thickness = 0.0;
            const TriangleMesh mesh = randomPrism(random, thickness);
            const int first = isLong ? 0 : static_cast<int>(random.below(kFiles));
            for (int number = first; number < (isLong ? kFiles : first + 1); ++number) {
                const QString fault = faultOf(mesh, thickness, roundedFile(mesh, number), counts);
                QVERIFY2(fault.isEmpty(), qPrintable(QString("seed %1, %2").arg(seed).arg(fault)));
            }
        }
        qInfo(
            "seeds 0 to %d: %d files refused, %d read, of which %d are fitted, within %g of the volume before rounding",
            static_cast<int>(seeds) - 1, counts.refused, counts.read, counts.fitted, counts.largestError);
        QVERIFY(counts.read > 2 * counts.refused && counts.largestError < 0.01);
    }
};

RUBBLE_TEST(RoundingTest)
#include "RoundingTest.moc"
