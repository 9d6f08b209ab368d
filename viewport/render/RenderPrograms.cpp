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
        return {compile(vertex, fragment, "WITHOUT_SHADOWS"), compile(vertex, fragment),
                compile(vertex, fragment, "BY_SAMPLES")};
    }
    const std::optional<Error>& error() const { return m_error; }

private:
    std::optional<Error> m_error;
};

}  // namespace

Result<RenderPrograms> compilePrograms() {
    ProgramCompiler compiler;
    RenderPrograms programs{
        .solid = compiler.compileLit({"bodies.glsl", "solid.vert"},
                                     {"shadow.glsl", "edge.glsl", "surface.glsl", "solid.frag"}),
        .transparent = compiler.compileLit({"bodies.glsl", "solid.vert"},
                                           {"shadow.glsl", "edge.glsl", "surface.glsl", "transparent.frag"}),
        .groundShadow = compiler.compileLit({"ground_shadow.vert"}, {"shadow.glsl", "ground_shadow.frag"}),
        .wires = compiler.compile({"bodies.glsl", "solid.vert"}, {"edge.glsl", "wires.frag"}),
        .depth = compiler.compile({"bodies.glsl", "depth.vert"}, {"depth.frag"}),
        .ditheredDepth = compiler.compile({"bodies.glsl", "depth.vert"}, {"dither.frag"}),
        .pick = compiler.compile({"bodies.glsl", "pick.vert"}, {"pick.frag"}),
        .sky = compiler.compile({"fullscreen.vert"}, {"sky.frag"}),
        .grid = compiler.compile({"grid.vert"}, {"grid.frag"}),
        .screenLines = compiler.compile({"screen_lines.vert"}, {"line.frag"}),
        .sceneLines = compiler.compile({"scene_lines.vert"}, {"line.frag"}),
        .dust = compiler.compile({"dust.vert"}, {"dust.frag"}),
        .mean = compiler.compile({"fullscreen.vert"}, {"mean.frag"}),
    };
    if (compiler.error()) return *compiler.error();
    return programs;
}

}  // namespace rubble
