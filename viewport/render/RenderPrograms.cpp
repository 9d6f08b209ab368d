#include "viewport/render/RenderPrograms.h"

#include <optional>

namespace rubble {
namespace {

/// Compiles programs and keeps the first error.
class ProgramCompiler {
public:
    using Files = std::initializer_list<std::string_view>;

    ShaderProgram compile(Files vertex, Files fragment, std::string_view defined = {}) {
        Result<ShaderProgram> program = ShaderProgram::create(vertex, fragment, defined);
        if (program) return std::move(*program);
        if (!m_error) m_error = program.error();
        return {};
    }
    LitPrograms compileLit(Files vertex, Files fragment) {
        return {compile(vertex, fragment, "WITHOUT_SHADOWS"), compile(vertex, fragment)};
    }
    const std::optional<Error>& error() const { return m_error; }

private:
    std::optional<Error> m_error;
};

/// `variant`: the file with the names that it defines.
LitPrograms compileSolid(ProgramCompiler& compiler, std::string_view variant) {
    return compiler.compileLit(
        {variant, "bodies.glsl", "solid.vert"},
        {variant, "light.glsl", "lit_by_buffer.glsl", "edge.glsl", "sky_light.glsl", "material.glsl",
         "surface_inputs.glsl", "hash.glsl", "finish.glsl", "surface.glsl", "solid.frag"});
}
LitPrograms compileTransparent(ProgramCompiler& compiler, std::string_view variant) {
    return compiler.compileLit(
        {variant, "bodies.glsl", "solid.vert"},
        {variant, "key_shadow.glsl", "lit_directly.glsl", "edge.glsl", "sky_light.glsl", "material.glsl",
         "surface_inputs.glsl", "hash.glsl", "finish.glsl", "surface.glsl", "transparent.frag"});
}

}  // namespace

Result<RenderPrograms> compilePrograms() {
    ProgramCompiler compiler;
    RenderPrograms programs{
        .solid = {.plain = compileSolid(compiler, "plain.glsl"),
                  .finished = compileSolid(compiler, "finished.glsl"),
                  .textured = compileSolid(compiler, "textured.glsl")},
        .transparent = {.plain = compileTransparent(compiler, "plain.glsl"),
                        .finished = compileTransparent(compiler, "finished.glsl"),
                        .textured = compileTransparent(compiler, "textured.glsl")},
        .ground = compiler.compileLit({"fullscreen.vert"}, {"camera.glsl", "light.glsl", "lit_by_buffer.glsl",
                                                            "background.glsl", "hash.glsl", "ground.frag"}),
        .concreteGround = compiler.compileLit(
            {"fullscreen.vert"}, {"concrete.glsl", "camera.glsl", "light.glsl", "lit_by_buffer.glsl", "background.glsl",
                                  "hash.glsl", "ground.frag"}),
        .skyFileGround = compiler.compileLit(
            {"fullscreen.vert"}, {"concrete.glsl", "camera.glsl", "light.glsl", "lit_by_buffer.glsl", "sky_file.glsl",
                                  "hash.glsl", "ground.frag"}),
        .particles = compiler.compileLit({"key_shadow.glsl", "lit_directly.glsl", "sky_light.glsl", "particles.vert"},
                                         {"camera.glsl", "particles.frag"}),
        .chips = compiler.compileLit(
            {"chip_form.glsl", "chips.vert"},
            {"key_shadow.glsl", "lit_directly.glsl", "sky_light.glsl", "material.glsl", "chips.frag"}),
        .surfaces = compiler.compile({"bodies.glsl", "solid.vert"}, {"surfaces.frag"}),
        .light = compiler.compile({"fullscreen.vert"},
                                  {"camera.glsl", "key_shadow.glsl", "sky.glsl", "light.glsl", "light.frag"}),
        .lightBlur = compiler.compile({"fullscreen.vert"}, {"camera.glsl", "light.glsl", "light_blur.frag"}),
        .wires = compiler.compile({"bodies.glsl", "solid.vert"}, {"edge.glsl", "wires.frag"}),
        .depth = compiler.compile({"bodies.glsl", "depth.vert"}, {"depth.frag"}),
        .glassShadow = compiler.compile({"bodies.glsl", "glass_shadow.vert"}, {"glass_shadow.frag"}),
        .screenLines = compiler.compile({"screen_lines.vert"}, {"line.frag"}),
        .sceneLines = compiler.compile({"scene_lines.vert"}, {"line.frag"}),
        .chipShadows = compiler.compile({"chip_form.glsl", "chip_shadows.vert"}, {"chip_shadows.frag"}),
        .decals = compiler.compile({"decals.vert"}, {"camera.glsl", "sky_light.glsl", "decals.frag"}),
        .marks = compiler.compile({"bodies.glsl", "marks.vert"}, {"sky_light.glsl", "marks.frag"}),
        .mean = compiler.compile({"fullscreen.vert"}, {"mean.frag"}),
    };
    if (compiler.error()) return *compiler.error();
    return programs;
}

}  // namespace rubble
