#include "viewport/render/gl/ShaderProgram.h"

#include "shader_source.h"

#include <epoxy/gl.h>

#include <iterator>
#include <string>

namespace rubble {
namespace {

struct Sampler {
    const char* name;
    TextureUnit unit;
};
constexpr Sampler kSamplers[] = {{"poses", TextureUnit::Poses},
                                 {"previousPoses", TextureUnit::PreviousPoses},
                                 {"explodeOffsets", TextureUnit::ExplodeOffsets},
                                 {"appearances", TextureUnit::Appearances},
                                 {"keyShadow", TextureUnit::KeyShadow},
                                 {"keyDepths", TextureUnit::KeyDepths},
                                 {"keyGlass", TextureUnit::KeyGlass},
                                 {"keyGlassShadow", TextureUnit::KeyGlassShadow},
                                 {"skyShadows", TextureUnit::SkyShadows},
                                 {"lightBuffer", TextureUnit::LightBuffer},
                                 {"source", TextureUnit::Source},
                                 {"depths", TextureUnit::Depths},
                                 {"mask", TextureUnit::Mask},
                                 {"weights", TextureUnit::Mask},
                                 {"normals", TextureUnit::Mask},
                                 {"baseColour", TextureUnit::BaseColour},
                                 {"reflections", TextureUnit::Reflections},
                                 {"restOffsets", TextureUnit::RestOffsets},
                                 {"finishNoise", TextureUnit::FinishNoise},
                                 {"skyFile", TextureUnit::SkyFile}};

/// The uniform blocks and their binding points.
constexpr const char* kBlocks[] = {"Frame", "Sky", "Finishes"};

/// Joins the lines of a driver's message.
std::string oneLine(std::string text) {
    for (char& letter : text) {
        if (letter == '\n' || letter == '\0') letter = ' ';
    }
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

Result<GlShader> compiled(std::uint32_t stage, std::initializer_list<std::string_view> files,
                          std::string_view defined) {
    std::string text = "#version 330 core\n";
    if (!defined.empty()) text.append("#define ").append(defined).append("\n");
    std::string_view last;
    text += shaderSource("frame.glsl");
    for (const std::string_view file : files) {
        RUBBLE_ASSERT(!shaderSource(file).empty());
        text += shaderSource(last = file);
    }
    GlShader shader(glCreateShader(stage));
    const char* source = text.c_str();
    glShaderSource(shader.id(), 1, &source, nullptr);
    glCompileShader(shader.id());
    GLint isCompiled = GL_FALSE;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &isCompiled);
    if (isCompiled == GL_TRUE) return shader;
    std::string log(4096, '\0');
    glGetShaderInfoLog(shader.id(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    return Error{ErrorCode::Unsupported,
                 "The graphics driver cannot compile " + std::string(last) + ": " + oneLine(std::move(log))};
}

}  // namespace

Result<ShaderProgram> ShaderProgram::create(std::initializer_list<std::string_view> vertexFiles,
                                            std::initializer_list<std::string_view> fragmentFiles,
                                            std::string_view defined) {
    const Result<GlShader> vertex = compiled(GL_VERTEX_SHADER, vertexFiles, defined);
    if (!vertex) return vertex.error();
    const Result<GlShader> fragment = compiled(GL_FRAGMENT_SHADER, fragmentFiles, defined);
    if (!fragment) return fragment.error();
    GlProgram program = GlProgram::create();
    glAttachShader(program.id(), vertex->id());
    glAttachShader(program.id(), fragment->id());
    glLinkProgram(program.id());
    GLint isLinked = GL_FALSE;
    glGetProgramiv(program.id(), GL_LINK_STATUS, &isLinked);
    if (isLinked != GL_TRUE) {
        std::string log(4096, '\0');
        glGetProgramInfoLog(program.id(), static_cast<GLsizei>(log.size()), nullptr, log.data());
        return Error{ErrorCode::Unsupported,
                     "The graphics driver cannot link a shader program: " + oneLine(std::move(log))};
    }
    ShaderProgram result(std::move(program));
    result.use();
    for (const Sampler& sampler : kSamplers) {
        glUniform1i(result.location(sampler.name), static_cast<GLint>(sampler.unit));
    }
    for (GLuint point = 0; point < std::size(kBlocks); ++point) {
        const GLuint block = glGetUniformBlockIndex(result.m_program.id(), kBlocks[point]);
        if (block != GL_INVALID_INDEX) glUniformBlockBinding(result.m_program.id(), block, point);
    }
    return result;
}

void ShaderProgram::use() const { glUseProgram(m_program.id()); }
int ShaderProgram::location(const char* name) const { return glGetUniformLocation(m_program.id(), name); }
void ShaderProgram::set(const char* name, float value) const { glUniform1f(location(name), value); }
void ShaderProgram::set(const char* name, std::uint32_t value) const { glUniform1ui(location(name), value); }
void ShaderProgram::set(const char* name, const glm::vec3& value) const { glUniform3fv(location(name), 1, &value[0]); }
void ShaderProgram::set(const char* name, const glm::vec4& value) const { glUniform4fv(location(name), 1, &value[0]); }
void ShaderProgram::set(const char* name, const glm::mat4& value) const {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, &value[0][0]);
}

}  // namespace rubble
