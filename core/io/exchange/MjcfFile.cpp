#include "core/io/exchange/MjcfFile.h"

#include "core/base/Assert.h"
#include "core/io/text/NumberText.h"
#include "core/io/text/XmlText.h"

#include <initializer_list>
#include <string_view>

namespace rubble {
namespace {

// 240 Hz; cones and impratio: with MuJoCo's defaults, stacks creep.
constexpr double kMjcfLeastMoment = 1e-14;  // kg·m²: MuJoCo refuses a model with a moment of 1e-15 or less

constexpr const char* kMjcfOption =
    R"(  <option timestep="0.004166666666666667" gravity="0 -9.81 0" cone="elliptic" impratio="100"/>)";

std::string mjcfNumbers(std::initializer_list<double> values) {
    std::string text;
    for (const double value : values) {
        if (!text.empty()) text += ' ';
        appendNumber(text, value);
    }
    return text;
}

std::string mjcfNumbers(Vec3 vector) { return mjcfNumbers({vector.x, vector.y, vector.z}); }

/// Adds an attribute of a valid text.
void addMjcfAttribute(std::string& line, std::string_view name, std::string_view value) {
    line.append(" ").append(name).append("=\"").append(value).append("\"");
}

std::string mjcfHullName(const PackBody& body, std::size_t number) {
    return escapedXml(body.name) + "_hull" + std::to_string(number);
}

void addMjcfMesh(std::string& text, const PackBody& body, std::size_t number) {
    text += "    <mesh";
    addMjcfAttribute(text, "name", mjcfHullName(body, number));
    std::string vertices;
    for (const Vec3& vertex : body.hulls[number].polytope.vertices)
        vertices.append(vertices.empty() ? "" : "  ").append(mjcfNumbers(vertex));
    addMjcfAttribute(text, "vertex", vertices);
    text += "/>\n";
}

void addMjcfFloor(std::string& text, const PackBody& whole, const Material& material) {
    RUBBLE_ASSERT(whole.bounds.has_value());
    text += "    <geom name=\"floor\" type=\"plane\" size=\"0 0 1\" zaxis=\"0 1 0\"";
    addMjcfAttribute(text, "pos", mjcfNumbers({0.0, whole.offset.y + whole.bounds->min.y, 0.0}));
    addMjcfAttribute(text, "friction", numberText(material.friction));
    text += "/>\n";
}

void addMjcfBody(std::string& text, const PackBody& body, const Material& material) {
    RUBBLE_ASSERT(body.principal.has_value());
    text += "    <body";
    addMjcfAttribute(text, "name", escapedXml(body.name));
    addMjcfAttribute(text, "pos", mjcfNumbers(body.offset));
    text += ">\n      <freejoint/>\n      <inertial";
    const auto& [moments, rotation] = *body.principal;
    addMjcfAttribute(text, "pos", mjcfNumbers(body.centreOfMass));
    addMjcfAttribute(text, "mass", numberText(body.mass));
    addMjcfAttribute(text, "diaginertia", mjcfNumbers(glm::max(moments, Vec3(kMjcfLeastMoment))));
    addMjcfAttribute(text, "quat", mjcfNumbers({rotation.w, rotation.x, rotation.y, rotation.z}));
    text += "/>\n";
    const Colour& colour = material.outside;
    for (std::size_t k = 0; k < body.hulls.size(); ++k) {
        text += "      <geom type=\"mesh\"";
        addMjcfAttribute(text, "mesh", mjcfHullName(body, k));
        addMjcfAttribute(text, "friction", numberText(material.friction));
        addMjcfAttribute(text, "rgba", mjcfNumbers({colour.red, colour.green, colour.blue, material.opacity}));
        text += "/>\n";
    }
    text += "    </body>\n";
}

}  // namespace

Result<std::string> mjcfFile(const PackBuilder& pack, std::span<const std::uint32_t> fragments,
                             const TaskContext& task) {
    const Pack header = pack.header({});
    std::string meshes, bodies;
    addMjcfFloor(bodies, pack.whole(), header.own());
    for (const std::uint32_t index : fragments) {
        if (task.isCancelled()) return TaskContext::cancelled();
        const PackBody body = pack.fragment(index);
        for (std::size_t k = 0; k < body.hulls.size(); ++k) addMjcfMesh(meshes, body, k);
        addMjcfBody(bodies, body, header.own());
    }
    std::string text = "<mujoco";
    addMjcfAttribute(text, "model", escapedXml(header.names.name));
    text.append(">\n").append(kMjcfOption).append("\n  <asset>\n").append(meshes);
    text.append("  </asset>\n  <worldbody>\n").append(bodies).append("  </worldbody>\n</mujoco>\n");
    return text;
}

}  // namespace rubble
