#include "core/geometry/mesh/SourceScene.h"

#include "core/base/Utf8.h"

#include <bit>
#include <cmath>

namespace rubble {
namespace {

constexpr std::string_view kMagic = "rubble mesh 5\n";

class ByteWriter {
public:
    void add(std::uint64_t value, int size) {
        for (int k = 0; k < size; ++k) m_bytes += static_cast<char>(value >> (8 * k) & 0xff);
    }
    void add(std::size_t count) { add(count, 4); }
    void add(double value) { add(std::bit_cast<std::uint64_t>(value), 8); }
    void add(std::string_view text) {
        add(text.size());
        m_bytes += text;
    }
    template <int size>
    void add(const glm::vec<size, double>& vector) {
        for (int k = 0; k < size; ++k) add(vector[k]);
    }
    std::string take() { return kMagic.data() + std::move(m_bytes); }

private:
    std::string m_bytes;
};

/// Reads values off bytes; once something was wrong, all that follows is zero.
class ByteReader {
public:
    explicit ByteReader(std::string_view bytes) : m_rest(bytes) {}

    std::uint64_t integer(int size) {
        const std::string_view bytes = take(size);
        std::uint64_t value = 0;
        for (std::size_t k = 0; k < bytes.size(); ++k)
            value |= std::uint64_t{static_cast<unsigned char>(bytes[k])} << (8 * k);
        return value;
    }
    /// A list's length, where so many elements of at least `elementSize` bytes can follow.
    std::size_t count(std::size_t elementSize) {
        const std::size_t count = integer(4);
        check(count <= m_rest.size() / elementSize);
        return isGood() ? count : 0;
    }
    std::uint32_t index(std::size_t count) {
        const auto index = static_cast<std::uint32_t>(integer(4));
        check(index < count);
        return index;
    }
    double number() {
        const double value = std::bit_cast<double>(integer(8));
        check(std::isfinite(value));
        return value;
    }
    template <int size>
    void read(glm::vec<size, double>& vector) {
        for (int k = 0; k < size; ++k) vector[k] = number();
    }
    std::string bytes() { return std::string(take(count(1))); }
    std::string text() {
        std::string bytes = this->bytes();
        check(isUtf8(bytes));
        return bytes;
    }

    void check(bool isRight) { m_isGood = m_isGood && isRight; }
    bool isGood() const { return m_isGood; }
    bool isAtEnd() const { return m_rest.empty(); }

private:
    std::string_view take(std::size_t size) {
        check(size <= m_rest.size());
        if (!m_isGood) return {};
        const std::string_view bytes = m_rest.substr(0, size);
        m_rest.remove_prefix(size);
        return bytes;
    }

    std::string_view m_rest;
    bool m_isGood = true;
};

constexpr std::size_t kMaterialSize = 4 + 3 * 8, kPointSize = 3 * 8, kTriangleSize = 3 * (4 + 2 * 8) + 4;
constexpr std::size_t kPoseSize = 7 * 8;
constexpr std::size_t kObjectSize = 4 + 1 + 4 + 4 + 4 + 8;
constexpr std::size_t kImageSize = 4 + 4;

void add(ByteWriter& writer, const Pose& pose) {
    writer.add(pose.position);
    for (int k = 0; k < 4; ++k) writer.add(pose.orientation[k]);
}

Pose readPose(ByteReader& reader) {
    constexpr double kUnitTolerance = 1e-9;
    Pose pose;
    reader.read(pose.position);
    for (int k = 0; k < 4; ++k) pose.orientation[k] = reader.number();
    reader.check(std::abs(glm::length(pose.orientation) - 1.0) <= kUnitTolerance);
    return pose;
}

SourceObject readObject(ByteReader& reader, std::size_t materialCount, std::size_t& triangleCount) {
    SourceObject object;
    object.name = reader.text();
    const auto hasUvs = reader.integer(1);
    reader.check(hasUvs <= 1);
    object.hasUvs = hasUvs == 1;
    object.points.resize(reader.count(kPointSize));
    for (Vec3& point : object.points) reader.read(point);
    const std::size_t triangles = reader.count(kTriangleSize);
    triangleCount += triangles;
    reader.check(triangles > 0 && triangleCount <= kMaxTriangles);
    if (!reader.isGood()) return object;
    object.triangles.resize(triangles);
    for (SourceTriangle& triangle : object.triangles) {
        for (std::uint32_t& point : triangle.points) point = reader.index(object.points.size());
        for (Vec2& uv : triangle.uvs) reader.read(uv);
        triangle.material = reader.index(materialCount);
    }
    const std::size_t copies = reader.count(kPoseSize);
    reader.check(copies <= kMaxCopies);
    for (std::size_t i = 0; i < copies && reader.isGood(); ++i) object.copies.push_back(readPose(reader));
    object.rounding = reader.number();
    reader.check(object.rounding >= 0.0);
    return object;
}

/// Reads the images, and which of them each material has.
void readImages(ByteReader& reader, SourceScene& scene) {
    const std::size_t count = reader.count(kImageSize);
    for (std::size_t i = 0; i < count && reader.isGood(); ++i) {
        std::string name = reader.text();
        Result<EncodedImage> image = EncodedImage::of(reader.bytes());
        reader.check(image.hasValue());
        if (image) scene.images.push_back({std::move(name), std::move(*image)});
    }
    for (SourceMaterial& material : scene.materials) {
        const std::uint32_t image = reader.index(scene.images.size() + 1);
        if (image > 0 && reader.isGood()) material.image = image - 1;
    }
}

}  // namespace

std::string sourceSceneBytes(const SourceScene& scene) {
    ByteWriter writer;
    writer.add(scene.metresPerUnit);
    writer.add(scene.materials.size());
    for (const SourceMaterial& material : scene.materials) {
        writer.add(std::string_view(material.name));
        writer.add(material.colour);
    }
    writer.add(scene.objects.size());
    for (const SourceObject& object : scene.objects) {
        writer.add(std::string_view(object.name));
        writer.add(object.hasUvs, 1);
        writer.add(object.points.size());
        for (const Vec3 point : object.points) writer.add(point);
        writer.add(object.triangles.size());
        for (const SourceTriangle& triangle : object.triangles) {
            for (const std::uint32_t point : triangle.points) writer.add(point, 4);
            for (const Vec2 uv : triangle.uvs) writer.add(uv);
            writer.add(triangle.material, 4);
        }
        writer.add(object.copies.size());
        for (const Pose& pose : object.copies) add(writer, pose);
        writer.add(object.rounding);
    }
    writer.add(scene.notes.size());
    for (const std::string& note : scene.notes) writer.add(std::string_view(note));
    writer.add(scene.images.size());
    for (const SourceImage& image : scene.images) {
        writer.add(std::string_view(image.name));
        writer.add(std::string_view(image.image.bytes()));
    }
    for (const SourceMaterial& material : scene.materials) writer.add(material.image ? *material.image + 1 : 0, 4);
    return writer.take();
}

Result<SourceScene> readSourceScene(std::string_view bytes) {
    const bool hasMagic = bytes.substr(0, kMagic.size()) == kMagic;
    ByteReader reader(hasMagic ? bytes.substr(kMagic.size()) : bytes);
    reader.check(hasMagic);
    SourceScene scene;
    scene.metresPerUnit = reader.number();
    reader.check(scene.metresPerUnit >= 0.0);
    scene.materials.resize(reader.count(kMaterialSize));
    for (SourceMaterial& material : scene.materials) {
        material.name = reader.text();
        reader.read(material.colour);
        for (int k = 0; k < 3; ++k) reader.check(material.colour[k] >= 0.0 && material.colour[k] <= 1.0);
    }
    std::size_t triangleCount = 0;
    const std::size_t objectCount = reader.count(kObjectSize);
    for (std::size_t i = 0; i < objectCount && reader.isGood(); ++i)
        scene.objects.push_back(readObject(reader, scene.materials.size(), triangleCount));
    const std::size_t noteCount = reader.count(sizeof(std::uint32_t));
    reader.check(noteCount <= kMaxNotes);
    if (reader.isGood()) scene.notes.resize(noteCount);
    for (std::string& note : scene.notes) note = reader.text();
    readImages(reader, scene);
    if (!reader.isGood() || !reader.isAtEnd()) return Error{ErrorCode::BadInput, "The bytes are not a valid mesh."};
    return scene;
}

}  // namespace rubble
