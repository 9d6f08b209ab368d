#pragma once

#include "core/base/Result.h"
#include "viewport/render/GlObjects.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <initializer_list>
#include <string_view>

namespace rubble {

/// A program of resources/shaders. All share the block Frame; samplers have fixed units (see kSamplers in the .cpp).
class ShaderProgram {
public:
    ShaderProgram() = default;  // none

    /// Made of files, each stage's put together in this order behind frame.glsl, with a name defined for #ifdef where one
    /// is given.
    ///
    /// Errors: Unsupported with what the driver says, where it does not take a file.
    static Result<ShaderProgram> made(std::initializer_list<std::string_view> vertexFiles,
                                      std::initializer_list<std::string_view> fragmentFiles,
                                      std::string_view defined = {});

    void use() const;
    /// Set a uniform of the program, which is in use.
    void set(const char* name, float value) const;
    void set(const char* name, std::uint32_t value) const;
    void set(const char* name, const glm::vec3& value) const;
    void set(const char* name, const glm::vec4& value) const;
    void set(const char* name, const glm::mat4& value) const;

private:
    explicit ShaderProgram(GlProgram program) : m_program(std::move(program)) {}
    int place(const char* name) const;

    GlProgram m_program;
};

/// The texture units that samplers read.
enum class TextureUnit : std::uint32_t { Motions, Earlier, Apart, Looks, KeyShadow, SkyShadow, Source, Depths, Heats };

}  // namespace rubble
