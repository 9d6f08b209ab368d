#include "viewport/render/Renderer.h"

#include "viewport/render/RenderPasses.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr int kPickMargin = 64;  // pixels around the pointer that are drawn at once, since it will move on

/// The view of the image that is scaled up.
RenderView atResolution(RenderView view) {
    const auto scaled = [&](int side) {
        return std::max(1, static_cast<int>(std::lround(view.resolution * static_cast<double>(side))));
    };
    view.size = {scaled(view.size.width), scaled(view.size.height)};
    view.settings.scale *= view.resolution;
    return view;
}

}  // namespace

/// The passes and their render targets.
struct Renderer::State : RenderPasses {
    using RenderPasses::RenderPasses;

    /// The cached target, recreated if it does not match.
    RenderTarget& target(RenderTarget& cached, ImageSize size, PixelFormat format, int samples) {
        if (!cached.matches(size, samples)) cached = RenderTarget(size, format, samples);
        return cached;
    }

    void drawSampleImage(const RenderView& view);
    void drawHovered(const RenderView& view, std::uint32_t framebuffer);

    RenderTarget image, sample, sum, bodies, depths;
    int samplesInSum = 0;
    /// The sample that continueSample() has begun.
    struct BegunSample {
        int index = 0;
        int steps = 0;  // done
        FrameBlock frame;
    };
    std::optional<BegunSample> begun;
    std::optional<Camera> bodiesCamera;  // of the content of `bodies`, as are the following two
    double bodiesStepFraction = 1.0;
    PixelBox bodiesPart;
};

Result<std::unique_ptr<Renderer>> Renderer::create() {
    if (epoxy_gl_version() < 33 || !epoxy_is_desktop_gl()) {
        const int version = epoxy_gl_version();
        return Error{ErrorCode::Unsupported, "Drawing needs OpenGL 3.3; this machine supports " +
                                                 std::to_string(version / 10) + "." + std::to_string(version % 10) +
                                                 "."};
    }
    Result<RenderPrograms> programs = compilePrograms();
    if (!programs) return programs.error();
    Result<OutlinePass> outlines = OutlinePass::create();
    if (!outlines) return outlines.error();
    Result<TransparencyPass> transparency = TransparencyPass::create();
    if (!transparency) return transparency.error();
    return std::unique_ptr<Renderer>(
        new Renderer(std::make_unique<State>(std::move(*programs), std::move(*outlines), std::move(*transparency))));
}

Renderer::Renderer(std::unique_ptr<State> state) : m_state(std::move(state)) {}
Renderer::~Renderer() = default;

void Renderer::setScene(std::shared_ptr<const RenderScene> scene) {
    m_state->setScene(std::move(scene));
    m_state->bodiesCamera.reset();
}

void Renderer::draw(const RenderView& view, std::uint32_t framebuffer) {
    State& state = *m_state;
    state.begun.reset();
    const RenderView drawn = atResolution(view);
    state.setShadows(drawn, singleSample(), true);
    state.setLight(drawn);
    const int wanted = view.settings.msaa > 0 ? view.settings.msaa : isSoftware() ? 1 : 4;
    const int samples = drawn.size == view.size ? wanted : 1;  // several cannot be scaled
    state.target(state.image, drawn.size, PixelFormat::Colour, samples).bind();
    state.drawImage(drawn);
    drawAgain(view, framebuffer);
}

void Renderer::drawAgain(const RenderView& view, std::uint32_t framebuffer) {
    m_state->image.copyColours(framebuffer, view.size);
    m_state->drawHovered(view, framebuffer);
}

void Renderer::addSample(const RenderView& view, int index) {
    m_state->begun.reset();
    while (!continueSample(view, index)) {
    }
}

bool Renderer::continueSample(const RenderView& view, int index) {
    State& state = *m_state;
    if (state.begun && state.begun->index == index)
        state.setFrame(state.begun->frame);
    else
        state.begun = {.index = index};
    switch (state.begun->steps++) {
        case 0: state.setShadows(view, lightSample(index), false); break;
        case 1: state.setLight(view); break;
        default:
            state.begun.reset();
            state.drawSampleImage(view);
            state.target(state.sum, view.size, PixelFormat::Float, 1).bind();
            if (index > 0) glEnable(GL_BLEND);
            glBlendFunc(GL_ONE, GL_ONE);
            state.drawScaled(state.sample, 1.0f);
            glDisable(GL_BLEND);
            state.samplesInSum = index + 1;
            return true;
    }
    state.begun->frame = state.frame;
    return false;
}

void Renderer::State::drawSampleImage(const RenderView& view) {
    target(sample, view.size, PixelFormat::Colour, 1).bind();
    drawImage(view);
}

void Renderer::drawMean(const RenderView& view, std::uint32_t framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, view.size.width, view.size.height);
    m_state->drawScaled(m_state->sum, 1.0f / static_cast<float>(m_state->samplesInSum));
    m_state->drawHovered(view, framebuffer);
}

/// Marks the body under the pointer over an image, which stays as it is.
void Renderer::State::drawHovered(const RenderView& view, std::uint32_t framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, view.size.width, view.size.height);
    if (!view.hovered) return;
    const Box3 box = boundsOfBody(*scene.scene(), *view.hovered);
    if (box.isEmpty()) return;
    const FrameBlock before = frame;
    setFrame(frameBlock(view, *scene.scene(), summary, singleSample()));
    frame.hovered.x = *view.hovered + 1;
    setFrame(frame);
    target(depths, view.size, PixelFormat::Colour, 1).bind();
    drawDepths();
    outlines.draw(scene, view, {.outlined = box, .depths = depths.framebuffer(), .image = framebuffer});
    setFrame(before);
}

void Renderer::finish() { glFinish(); }

const RenderCounts& Renderer::counts() const { return m_state->scene.counts(); }

bool Renderer::isSoftware() const {
    const std::string_view name(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    return name.find("llvmpipe") != name.npos || name.find("softpipe") != name.npos;
}

std::optional<std::uint32_t> Renderer::bodyAt(const RenderView& view, int x, int y) {
    State& state = *m_state;
    if (x < 0 || y < 0 || x >= view.size.width || y >= view.size.height) return std::nullopt;
    const int up = view.size.height - 1 - y;
    const bool isCached = state.bodies.matches(view.size, 1) && state.bodiesCamera == view.camera &&
                          state.bodiesStepFraction == view.stepFraction && state.bodiesPart.contains(x, up);
    state.target(state.bodies, view.size, PixelFormat::BodyIndex, 1).bind();
    if (!isCached) {
        state.bodiesPart = {x - kPickMargin, up - kPickMargin, 2 * kPickMargin + 1, 2 * kPickMargin + 1};
        state.drawBodies(view, state.bodiesPart);
        state.bodiesCamera = view.camera;
        state.bodiesStepFraction = view.stepFraction;
    }
    std::uint32_t body = 0;
    glReadPixels(x, up, 1, 1, GL_RED_INTEGER, GL_UNSIGNED_INT, &body);
    if (body == 0) return std::nullopt;
    return body - 1;
}

}  // namespace rubble
