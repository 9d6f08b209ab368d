#include "core/io/GlbJson.h"

#include "core/io/JsonText.h"
#include "core/io/NumberText.h"

namespace rubble {
namespace {

// Numbers that the glTF 2.0 specification gives to things.
constexpr std::uint32_t kFloat = 5126;
constexpr std::uint32_t kUnsignedInt = 5125;
constexpr std::uint32_t kArrayBuffer = 34962;
constexpr std::uint32_t kElementArrayBuffer = 34963;

/// The root x of x^5 = value for a value in (0, 1], by Newton's method from above: the same bits on every processor.
double fifthRoot(double value) {
    double root = 1.0;
    for (int round = 0; round < 40; ++round) {
        const double fourth = root * root * root * root;
        root -= (fourth * root - value) / (5.0 * fourth);
    }
    return root;
}

/// A part of an sRGB colour in proportion to light, as glTF has colours.
/// Source: IEC 61966-2-1.
double linearFromSrgb(double part) {
    if (part <= 0.04045) return part / 12.92;
    const double square = (part + 0.055) * (part + 0.055) / (1.055 * 1.055);
    return square * fifthRoot(square);  // to the power of 2.4
}

/// Writes the chunk list by list, in the order of the public function below.
class GlbJson {
public:
    GlbJson(const GlbBuffer& buffer, const MeshMaterials& materials) : m_buffer(buffer), m_materials(materials) {}

    void addNodes(std::span<const MeshPart> parts, PartPlace place) {
        m_json += R"({"asset":{"version":"2.0","generator":"Rubble"},"scene":0,"scenes":[{"nodes":)";
        std::uint32_t index = 0;
        addArray(parts, [&](const MeshPart&) { appendNumber(m_json, index++); });
        m_json += R"(}],"nodes":)";
        index = 0;
        addArray(parts, [&](const MeshPart& part) {
            addNamed(part.name);
            m_json += ",\"mesh\":";
            appendNumber(m_json, index++);
            if (place == PartPlace::Assembled) {
                m_json += ",\"translation\":";
                addNumbers(std::array{part.offset.x, part.offset.y, part.offset.z});
            }
            m_json += '}';
        });
    }

    void addMeshes(std::span<const MeshPart> parts, std::span<const std::vector<GlbPrimitive>> primitives) {
        m_json += ",\"meshes\":";
        std::size_t index = 0;
        std::uint32_t accessor = 0;
        addArray(parts, [&](const MeshPart& part) {
            addNamed(part.name);
            m_json += ",\"primitives\":";
            addArray(primitives[index++], [&](const GlbPrimitive& primitive) { addPrimitive(primitive, accessor); });
            m_json += '}';
        });
    }

    void addMaterials() {
        m_json += ",\"materials\":";
        std::vector<MeshMaterial> all = m_materials.outside;
        all.push_back(m_materials.inside);
        addArray(all, [&](const MeshMaterial& material) {
            addNamed(material.name);
            m_json += R"(,"pbrMetallicRoughness":{"baseColorFactor":)";
            const Colour& colour = material.colour;
            addNumbers(
                std::array{linearFromSrgb(colour.red), linearFromSrgb(colour.green), linearFromSrgb(colour.blue), 1.0});
            m_json += R"(,"metallicFactor":0,"roughnessFactor":0.9}})";
        });
    }

    /// Four accessors a primitive, in the order of the buffer's lists.
    void addAccessors(std::span<const std::vector<GlbPrimitive>> primitives) {
        m_json += ",\"accessors\":[";
        for (const std::vector<GlbPrimitive>& part : primitives) {
            for (const GlbPrimitive& primitive : part) {
                addAccessor(0, 12 * std::uint64_t{primitive.firstVertex}, kFloat, primitive.vertexCount, "VEC3");
                m_json += ",\"min\":";
                addNumbers(primitive.min);
                m_json += ",\"max\":";
                addNumbers(primitive.max);
                m_json += "},";
                addAccessor(1, 12 * std::uint64_t{primitive.firstVertex}, kFloat, primitive.vertexCount, "VEC3");
                m_json += "},";
                addAccessor(2, 8 * std::uint64_t{primitive.firstVertex}, kFloat, primitive.vertexCount, "VEC2");
                m_json += "},";
                addAccessor(3, 4 * std::uint64_t{primitive.firstIndex}, kUnsignedInt, primitive.indexCount, "SCALAR");
                m_json += "},";
            }
        }
        m_json.back() = ']';
    }

    void addBuffer() {
        m_json += ",\"bufferViews\":[";
        std::uint64_t offset = 0;
        const std::uint64_t vertices = m_buffer.vertexCount();
        addView(offset, 12 * vertices, R"("byteStride":12,)", kArrayBuffer);
        addView(offset, 12 * vertices, R"("byteStride":12,)", kArrayBuffer);
        addView(offset, 8 * vertices, R"("byteStride":8,)", kArrayBuffer);
        addView(offset, 4 * std::uint64_t{m_buffer.indexCount()}, "", kElementArrayBuffer);
        m_json.back() = ']';
        m_json += R"(,"buffers":[{"byteLength":)" + std::to_string(m_buffer.size()) + "}]}";
    }

    std::string text() && { return std::move(m_json); }

private:
    template <class Elements, class Add>
    void addArray(const Elements& elements, Add add) {
        m_json += '[';
        for (const auto& element : elements) {
            if (m_json.back() != '[') m_json += ',';
            add(element);
        }
        m_json += ']';
    }

    /// As doubles: a float's own digits would be another number to a reader that knows doubles only.
    template <class Numbers>
    void addNumbers(const Numbers& numbers) {
        addArray(numbers, [&](double number) { appendNumber(m_json, number); });
    }

    /// The beginning of an object with a name.
    void addNamed(const std::string& name) {
        m_json += "{\"name\":";
        appendJsonText(m_json, name);
    }

    void addPrimitive(const GlbPrimitive& primitive, std::uint32_t& accessor) {
        const auto inside = static_cast<std::uint32_t>(m_materials.outside.size());
        for (const char* before :
             {R"({"attributes":{"POSITION":)", R"(,"NORMAL":)", R"(,"TEXCOORD_0":)", R"(},"indices":)"}) {
            m_json += before;
            appendNumber(m_json, accessor++);
        }
        m_json += ",\"material\":";
        appendNumber(m_json, primitive.material == GlbBuffer::kInside ? inside : primitive.material);
        m_json += '}';
    }

    /// An accessor that is still open.
    void addAccessor(std::uint32_t view, std::uint64_t offset, std::uint32_t component, std::uint32_t count,
                     const char* type) {
        m_json += "{\"bufferView\":";
        appendNumber(m_json, view);
        m_json += ",\"byteOffset\":" + std::to_string(offset) + ",\"componentType\":";
        appendNumber(m_json, component);
        m_json += ",\"count\":";
        appendNumber(m_json, count);
        m_json += std::string(",\"type\":\"") + type + '"';
    }

    /// A view with a comma behind it; moves `offset` to its end.
    void addView(std::uint64_t& offset, std::uint64_t length, const char* stride, std::uint32_t target) {
        m_json += R"({"buffer":0,"byteOffset":)" + std::to_string(offset) + ",\"byteLength\":" + std::to_string(length);
        m_json += std::string(",") + stride + "\"target\":" + std::to_string(target) + "},";
        offset += length;
    }

    const GlbBuffer& m_buffer;
    const MeshMaterials& m_materials;
    std::string m_json;
};

}  // namespace

std::string glbJson(std::span<const MeshPart> parts, std::span<const std::vector<GlbPrimitive>> primitives,
                    const GlbBuffer& buffer, const MeshMaterials& materials, PartPlace place) {
    GlbJson json(buffer, materials);
    json.addNodes(parts, place);
    json.addMeshes(parts, primitives);
    json.addMaterials();
    json.addAccessors(primitives);
    json.addBuffer();
    return std::move(json).text();
}

}  // namespace rubble
