#include "viewport/render/Renderer.h"

#include "viewport/render/AxesCross.h"
#include "viewport/render/FrameBlock.h"
#include "viewport/render/RenderTarget.h"
#include "viewport/render/SceneBuffers.h"
#include "viewport/render/ShaderProgram.h"
#include "viewport/render/ShadowMap.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>

namespace rubble {
namespace {

constexpr int kShadowWidth = 2048;    // texels: some 5 mm at a house
constexpr int kSkyShadowWidth = 512;  // soft: the sky is wide
constexpr int kPickReach = 64;        // pixels around the pointer that are drawn at once, since it will move on

enum class Light { Plain, Shadowed, Sampled };

/// What is drawn with light, in the three ways of shadow.glsl.
struct LitPrograms {
    ShaderProgram plain, shadowed, sampled;
};

struct Programs {
    LitPrograms solid, shade;
    ShaderProgram lines, depth, pick, sky, grid, strokes, mean;
};

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

Result<Programs> madePrograms() {
    ProgramMaker maker;
    Programs programs{
        .solid = maker.madeLit({"bodies.glsl", "solid.vert"}, {"shadow.glsl", "edge.glsl", "solid.frag"}),
        .shade = maker.madeLit({"shade.vert"}, {"shadow.glsl", "shade.frag"}),
        .lines = maker.made({"bodies.glsl", "solid.vert"}, {"edge.glsl", "lines.frag"}),
        .depth = maker.made({"bodies.glsl", "depth.vert"}, {"depth.frag"}),
        .pick = maker.made({"bodies.glsl", "pick.vert"}, {"pick.frag"}),
        .sky = maker.made({"whole.vert"}, {"sky.frag"}),
        .grid = maker.made({"grid.vert"}, {"grid.frag"}),
        .strokes = maker.made({"strokes.vert"}, {"strokes.frag"}),
        .mean = maker.made({"whole.vert"}, {"mean.frag"}),
    };
    if (maker.fault()) return *maker.fault();
    return programs;
}

void setCapability(std::uint32_t capability, bool isOn) { isOn ? glEnable(capability) : glDisable(capability); }

/// A part of a picture, pixels from the lower left corner.
struct PixelBox {
    int x = 0, y = 0, width = 0, height = 0;
    bool contains(int px, int py) const { return px >= x && py >= y && px < x + width && py < y + height; }
};

/// What is drawn beside or over solid faces.
struct LinePass {
    glm::vec4 line{0.0f};
    glm::vec4 fill{0.0f};
    float width = 1.0f;
    std::uint32_t onlyMarks = 0;
    std::uint32_t depthFunction = GL_LEQUAL;  // GL_ALWAYS: through everything
    SceneBuffers::Part part = SceneBuffers::Part::Bodies;
};

glm::vec4 withOpacity(glm::vec4 colour, float opacity) { return {glm::vec3(colour), opacity}; }

}  // namespace

struct Renderer::State {
    explicit State(Programs made) : programs(std::move(made)) {}

    void setFrame(const FrameBlock& block);
    void drawShadows(const PictureView& view, const std::optional<LightSample>& lightSample);
    void drawPicture(const PictureView& view);
    const ShaderProgram& lit(const LitPrograms& ways) const;
    void drawBackground();
    void drawSolid();
    void drawWires(const PictureView& view);
    void drawHulls(const PictureView& view);
    void drawLines(const LinePass& pass);
    void drawGround(const PictureView& view);
    void drawAxes(const PictureView& view);
    void drawBodies(const PictureView& view, const PixelBox& part);
    void drawWhole() const;
    void drawTimes(const RenderTarget& source, float share) const;
    RenderTarget& target(RenderTarget& kept, PictureSize size, PixelFormat format, int samples);

    Programs programs;
    SceneBuffers scene;
    Box3 bounds;
    bool hasSelected = false;
    ShadowMap keyShadow{kShadowWidth};
    ShadowMap skyShadow{kSkyShadowWidth};
    bool areShadowsOfScene = false;  // those of `scene`, by the middle of the lights
    Light light = Light::Plain;
    FrameBlock frame{};
    GlBuffer frameBuffer = GlBuffer::made();
    GlVertexArray nothing = GlVertexArray::made();  // for what needs no vertices
    GlVertexArray strokeArray = GlVertexArray::made();
    GlBuffer strokeBuffer = GlBuffer::made();
    RenderTarget picture, sample, sum, bodies;
    int samplesTaken = 0;                // in `sum`
    std::optional<Camera> bodiesCamera;  // that `bodies` was drawn by
    PixelBox bodiesPart;                 // where it was
};

void Renderer::State::setFrame(const FrameBlock& block) {
    frame = block;
    glBindBuffer(GL_UNIFORM_BUFFER, frameBuffer.id());
    glBufferData(GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, frameBuffer.id());
}

RenderTarget& Renderer::State::target(RenderTarget& kept, PictureSize size, PixelFormat format, int samples) {
    if (!kept.isLike(size, samples)) kept = RenderTarget(size, format, samples);
    return kept;
}

void Renderer::State::drawWhole() const {
    glBindVertexArray(nothing.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// Covers what is bound with a target's colours times a number.
void Renderer::State::drawTimes(const RenderTarget& source, float share) const {
    glDisable(GL_DEPTH_TEST);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::Source));
    glBindTexture(GL_TEXTURE_2D, source.colourTexture());
    programs.mean.use();
    programs.mean.set("share", share);
    drawWhole();
}

void Renderer::State::drawShadows(const PictureView& view, const std::optional<LightSample>& lightSample) {
    light = Light::Plain;
    if (!view.settings.hasShadows || view.settings.shading != Shading::Faces || bounds.isEmpty()) return;
    light = lightSample ? Light::Sampled : Light::Shadowed;
    if (!lightSample && areShadowsOfScene) return;
    setFrame(frame);  // for its exploded factor
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    keyShadow.draw(scene, programs.depth, lightSample ? lightSample->keyDirection : keyDirection(), bounds);
    if (lightSample) skyShadow.draw(scene, programs.depth, lightSample->skyDirection, bounds);
    areShadowsOfScene = !lightSample;
}

const ShaderProgram& Renderer::State::lit(const LitPrograms& ways) const {
    return light == Light::Plain ? ways.plain : light == Light::Shadowed ? ways.shadowed : ways.sampled;
}

void Renderer::State::drawBackground() {
    glDisable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    programs.sky.use();
    drawWhole();
    glDepthMask(GL_TRUE);
    glEnable(GL_DEPTH_TEST);
}

void Renderer::State::drawSolid() {
    glEnable(GL_CULL_FACE);
    glDepthFunc(GL_LESS);
    lit(programs.solid).use();
    scene.draw(SceneBuffers::Part::Bodies);
    glDisable(GL_CULL_FACE);
}

void Renderer::State::drawLines(const LinePass& pass) {
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    glDepthFunc(pass.depthFunction);
    setCapability(GL_POLYGON_OFFSET_FILL, pass.depthFunction == GL_LEQUAL);
    glPolygonOffset(-1.0f, -2.0f);
    programs.lines.use();
    programs.lines.set("lineColour", pass.line);
    programs.lines.set("fillColour", pass.fill);
    programs.lines.set("lineWidth", pass.width * frame.picture.w);
    programs.lines.set("onlyMarks", pass.onlyMarks);
    scene.draw(pass.part);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
}

void Renderer::State::drawWires(const PictureView& view) {
    const glm::vec4 colour = surroundingsOf(view.settings.theme).wires;
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    programs.depth.use();
    programs.depth.set("clipFromSceneOfLight", frame.clipFromScene);
    glDepthFunc(GL_LESS);
    scene.draw(SceneBuffers::Part::Bodies);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    drawLines({.line = withOpacity(colour, 0.16f), .width = 0.6f, .depthFunction = GL_ALWAYS});
    drawLines({.line = withOpacity(colour, 0.85f), .fill = withOpacity(colour, 0.03f), .width = 0.7f});
}

void Renderer::State::drawHulls(const PictureView& view) {
    const glm::vec4 colour = surroundingsOf(view.settings.theme).hulls;
    const auto part = SceneBuffers::Part::Hulls;
    drawLines({.line = withOpacity(colour, 0.2f), .width = 0.7f, .depthFunction = GL_ALWAYS, .part = part});
    drawLines({.line = withOpacity(colour, 1.0f), .fill = withOpacity(colour, 0.14f), .width = 1.3f, .part = part});
}

void Renderer::State::drawGround(const PictureView& view) {
    if (!scene.scene()->hasGround) return;
    glEnable(GL_BLEND);
    glEnable(GL_DEPTH_CLAMP);  // it reaches beyond what the depth was made for
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    glBindVertexArray(nothing.id());
    if (light != Light::Plain && !bounds.isEmpty()) {
        lit(programs.shade).use();
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    if (view.settings.hasGrid) {
        programs.grid.use();
        programs.grid.set("worldOrigin", gridOrigin(frame, *scene.scene()));
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_BLEND);
}

void Renderer::State::drawAxes(const PictureView& view) {
    const std::vector<Stroke> strokes = axesCross(view.camera, view.settings.scale);
    glBindVertexArray(strokeArray.id());
    glBindBuffer(GL_ARRAY_BUFFER, strokeBuffer.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(strokes.size() * sizeof(Stroke)), strokes.data(),
                 GL_STREAM_DRAW);
    const auto describe = [](GLuint attribute, GLint count, std::size_t offset) {
        glVertexAttribPointer(attribute, count, GL_FLOAT, GL_FALSE, sizeof(Stroke),
                              reinterpret_cast<const void*>(offset));
        glVertexAttribDivisor(attribute, 1);
        glEnableVertexAttribArray(attribute);
    };
    describe(0, 4, offsetof(Stroke, ends));
    describe(1, 4, offsetof(Stroke, colour));
    describe(2, 1, offsetof(Stroke, radius));
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    programs.strokes.use();
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(strokes.size()));
    glDisable(GL_BLEND);
}

void Renderer::State::drawPicture(const PictureView& view) {
    keyShadow.bind(TextureUnit::KeyShadow);
    skyShadow.bind(TextureUnit::SkyShadow);
    frame.keyFromScene = keyShadow.placeFromScene();
    frame.skyFromScene = skyShadow.placeFromScene();
    setFrame(frame);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    drawBackground();
    const bool isSolid = view.settings.shading == Shading::Faces;
    if (isSolid)
        drawSolid();
    else
        drawWires(view);
    drawGround(view);
    drawHulls(view);
    if (hasSelected && isSolid) {
        drawLines({.line = withOpacity(frame.accent, 0.45f),
                   .fill = withOpacity(frame.accent, 0.06f),
                   .width = 1.2f,
                   .onlyMarks = kSelected,
                   .depthFunction = GL_GREATER});
    }
    if (view.settings.hasAxes) drawAxes(view);
}

Result<std::unique_ptr<Renderer>> Renderer::made() {
    if (epoxy_gl_version() < 33 || !epoxy_is_desktop_gl()) {
        const int version = epoxy_gl_version();
        return Error{ErrorCode::Unsupported, "Drawing needs OpenGL 3.3; this machine offers " +
                                                 std::to_string(version / 10) + "." + std::to_string(version % 10) +
                                                 "."};
    }
    Result<Programs> programs = madePrograms();
    if (!programs) return programs.error();
    return std::unique_ptr<Renderer>(new Renderer(std::make_unique<State>(std::move(*programs))));
}

Renderer::Renderer(std::unique_ptr<State> state) : m_state(std::move(state)) {}
Renderer::~Renderer() = default;

void Renderer::setScene(std::shared_ptr<const RenderScene> scene) {
    m_state->bounds = boundsOf(*scene);
    m_state->hasSelected =
        std::ranges::any_of(scene->looks, [](const BodyLook& look) { return (look.marks & kSelected) != 0; });
    m_state->scene.upload(std::move(scene));
    m_state->areShadowsOfScene = false;
    m_state->bodiesCamera.reset();
}

void Renderer::draw(const PictureView& view, std::uint32_t framebuffer) {
    State& state = *m_state;
    state.frame = frameBlock(view, *state.scene.scene(), state.bounds, {});
    state.drawShadows(view, {});
    const int samples = view.settings.msaa > 0 ? view.settings.msaa : isSoftware() ? 1 : 4;
    RenderTarget& target = state.target(state.picture, view.size, PixelFormat::Colour, samples);
    target.bind();
    state.drawPicture(view);
    copyColours(target.framebuffer(), framebuffer, view.size);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

void Renderer::addSample(const PictureView& view, int index) {
    State& state = *m_state;
    const LightSample light = lightSample(index);
    state.frame = frameBlock(view, *state.scene.scene(), state.bounds, light);
    state.drawShadows(view, light);
    RenderTarget& sample = state.target(state.sample, view.size, PixelFormat::Colour, 1);
    sample.bind();
    state.drawPicture(view);
    state.target(state.sum, view.size, PixelFormat::Float, 1).bind();
    setCapability(GL_BLEND, index > 0);
    glBlendFunc(GL_ONE, GL_ONE);
    state.drawTimes(sample, 1.0f);
    glDisable(GL_BLEND);
    state.samplesTaken = index + 1;
}

void Renderer::showMean(const PictureView& view, std::uint32_t framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, view.size.width, view.size.height);
    m_state->drawTimes(m_state->sum, 1.0f / static_cast<float>(m_state->samplesTaken));
}

bool Renderer::isSoftware() const {
    const std::string_view name(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    return name.find("llvmpipe") != name.npos || name.find("softpipe") != name.npos;
}

void Renderer::State::drawBodies(const PictureView& view, const PixelBox& part) {
    setFrame(frameBlock(view, *scene.scene(), bounds, {}));
    glEnable(GL_SCISSOR_TEST);
    glScissor(part.x, part.y, part.width, part.height);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glEnable(GL_CULL_FACE);
    constexpr std::uint32_t kNothing[4] = {0, 0, 0, 0};
    glClearBufferuiv(GL_COLOR, 0, kNothing);
    glClear(GL_DEPTH_BUFFER_BIT);
    programs.pick.use();
    scene.draw(SceneBuffers::Part::Bodies);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
}

std::optional<std::uint32_t> Renderer::bodyAt(const PictureView& view, int x, int y) {
    State& state = *m_state;
    if (x < 0 || y < 0 || x >= view.size.width || y >= view.size.height) return std::nullopt;
    const int up = view.size.height - 1 - y;
    const bool isKept =
        state.bodies.isLike(view.size, 1) && state.bodiesCamera == view.camera && state.bodiesPart.contains(x, up);
    state.target(state.bodies, view.size, PixelFormat::BodyIndex, 1).bind();
    if (!isKept) {
        state.bodiesPart = {x - kPickReach, up - kPickReach, 2 * kPickReach + 1, 2 * kPickReach + 1};
        state.drawBodies(view, state.bodiesPart);
        state.bodiesCamera = view.camera;
    }
    std::uint32_t body = 0;
    glReadPixels(x, up, 1, 1, GL_RED_INTEGER, GL_UNSIGNED_INT, &body);
    if (body == 0) return std::nullopt;
    return body - 1;
}

}  // namespace rubble
