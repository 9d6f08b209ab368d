#include "viewport/render/RenderPrograms.h"

#include <optional>

namespace rubble {
namespace {

/// Makes programs, and remembers the first fault.
class ProgramMaker {
public:
    using Files = std::initializer_list<std::string_view>;

    ShaderProgram made(Files vertex, Files fragment, std::string_view defined = {}) {
        Result<ShaderProgram> program = ShaderProgram::made(vertex, fragment, defined);
        if (program) return std::move(*program);
        if (!m_fault) m_fault = program.error();
        return {};
    }
    LitPrograms madeLit(Files vertex, Files fragment) {
        return {made(vertex, fragment, "WITHOUT_SHADOWS"), made(vertex, fragment),
                made(vertex, fragment, "BY_SAMPLES")};
    }
    const std::optional<Error>& fault() const { return m_fault; }

private:
    std::optional<Error> m_fault;
};

}  // namespace

Result<RenderPrograms> madePrograms() {
    ProgramMaker maker;
    RenderPrograms programs{
        .solid = maker.madeLit({"bodies.glsl", "solid.vert"}, {"shadow.glsl", "edge.glsl", "plain.glsl", "solid.frag"}),
        .heated = maker.madeLit({"bodies.glsl", "solid.vert"}, {"shadow.glsl", "edge.glsl", "heat.glsl", "solid.frag"}),
        .shade = maker.madeLit({"shade.vert"}, {"shadow.glsl", "shade.frag"}),
        .lines = maker.made({"bodies.glsl", "solid.vert"}, {"edge.glsl", "lines.frag"}),
        .depth = maker.made({"bodies.glsl", "depth.vert"}, {"depth.frag"}),
        .pick = maker.made({"bodies.glsl", "pick.vert"}, {"pick.frag"}),
        .sky = maker.made({"whole.vert"}, {"sky.frag"}),
        .grid = maker.made({"grid.vert"}, {"grid.frag"}),
        .strokes = maker.made({"strokes.vert"}, {"strokes.frag"}),
        .spans = maker.made({"spans.vert"}, {"strokes.frag"}),
        .dust = maker.made({"dust.vert"}, {"dust.frag"}),
        .mean = maker.made({"whole.vert"}, {"mean.frag"}),
    };
    if (maker.fault()) return *maker.fault();
    return programs;
}

}  // namespace rubble
