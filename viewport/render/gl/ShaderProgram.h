#pragma once

#include "core/base/Result.h"
#include "viewport/render/gl/GlObjects.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <initializer_list>
#include <string_view>

namespace rubble {

/// A shader program of resources/shaders. All share the uniform block Frame; samplers have fixed texture units.
class ShaderProgram {
public:
    ShaderProgram() = default;  // none

    /// Compiles and links a program. Each stage is frame.glsl followed by the given files in order; `defined`, if not
    /// empty, is a #define for both.
    ///
    /// Errors: Unsupported, with the driver's message, if it rejects a file.
    static Result<ShaderProgram> create(std::initializer_list<std::string_view> vertexFiles,
                                        std::initializer_list<std::string_view> fragmentFiles,
                                        std::string_view defined = {});

    void use() const;
    /// Sets a uniform; the program must be in use.
    void set(const char* name, float value) const;
    void set(const char* name, std::uint32_t value) const;
    void set(const char* name, const glm::vec3& value) const;
    void set(const char* name, const glm::vec4& value) const;
    void set(const char* name, const glm::mat4& value) const;

private:
    explicit ShaderProgram(GlProgram program) : m_program(std::move(program)) {}
    int location(const char* name) const;

    GlProgram m_program;
};

/// Texture units of the samplers.
enum class TextureUnit : std::uint32_t {
    Poses,
    PreviousPoses,
    ExplodeOffsets,
    Appearances,
    KeyShadow,
    KeyDepths,
    KeyGlass,
    KeyGlassShadow,
    SkyShadows,
    LightBuffer,
    Source,
    Depths,
    Mask,
    BaseColour,
    Reflections,
    RestOffsets,
    FinishNoise,
    SkyFile
};

}  // namespace rubble
