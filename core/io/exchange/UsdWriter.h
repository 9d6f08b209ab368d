#pragma once

#include "core/geometry/predicates/Vec.h"

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// Unique names of the prims below one prim: letters and digits of ASCII and '_', the first no digit.
class UsdNames {
public:
    /// Returns `name` with '_' for each other character, and a number after it where it is taken.
    std::string unique(std::string_view name);

private:
    std::set<std::string> m_taken;
};

/// What each value of an array belongs to, where its attribute does not say: a corner of a face.
enum class UsdInterpolation { None, FaceVarying };

/// The time codes of a layer whose attributes change.
struct UsdTimes {
    std::uint32_t last = 0;  // the first is 0
    double perSecond = 1.0;
};

/// Writes the text of a USD layer (.usda): prims, their attributes and relationships, indented. `declaration` is the
/// type and name of an attribute, "float physics:mass". Numbers of single precision are the shortest that read back.
class UsdWriter {
public:
    UsdWriter(std::string_view defaultPrim, std::string_view documentation, const std::optional<UsdTimes>& times = {});

    /// Begins a prim of a type, with applied API schemas; returns its path, "</wall/Materials>" without the brackets.
    std::string begin(std::string_view type, std::string_view name, std::initializer_list<std::string_view> apis = {});
    void end();

    void addOutput(std::string_view declaration);                          // of a shader: without a value
    void setWord(std::string_view declaration, std::string_view value);    // the value as it is
    void setDouble(std::string_view declaration, double value);            //
    void setFloat(std::string_view declaration, double value);             //
    void setText(std::string_view declaration, std::string_view value);    // a string or token: quoted
    void setAsset(std::string_view declaration, std::string_view file);    // a file beside the layer
    void setTarget(std::string_view declaration, std::string_view path);   // a relationship or connection
    void setDoubles(std::string_view declaration, Vec3 value);             // double3
    void setFloats(std::string_view declaration, Vec3 value);              // float3, point3f, vector3f, color3f
    void setRotation(std::string_view declaration, const Quat& rotation);  // quatf: w first
    void setTexts(std::string_view declaration, std::initializer_list<std::string_view> values);
    void setIndices(std::string_view declaration, std::span<const std::uint32_t> values);
    void setPoints(std::string_view declaration, std::span<const Vec3> values,
                   UsdInterpolation interpolation = UsdInterpolation::None);
    void setPoints(std::string_view declaration, std::span<const Vec2> values,
                   UsdInterpolation interpolation = UsdInterpolation::None);

    /// Begins the values of an attribute at times; ascending samples of one kind follow.
    void beginSamples(std::string_view declaration);
    void addSample(std::uint32_t time, std::string_view value);  // the value as it is
    void addSample(std::uint32_t time, Vec3 value);
    void addSample(std::uint32_t time, const Quat& value);  // w first
    void endSamples();

    /// The text. All prims have ended.
    std::string text() &&;

private:
    void indent();
    void declare(std::string_view declaration);
    void beginSample(std::uint32_t time);
    void addQuoted(std::string_view text);
    void addTuple(std::initializer_list<double> values);
    void endArray(UsdInterpolation interpolation);

    std::string m_text;
    std::vector<std::string> m_path;
};

}  // namespace rubble
