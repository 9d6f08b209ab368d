#include "viewport/render/Renderer.h"

#include "viewport/render/RenderPasses.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace rubble {
namespace {

constexpr int kPickMargin = 64;  // pixels around the pointer that are drawn at once, since it will move on

}  // namespace

/// The passes and their render targets.
struct Renderer::State : RenderPasses {
    using RenderPasses::RenderPasses;

    /// The cached target, recreated if it does not match.
    RenderTarget& target(RenderTarget& cached, ImageSize size, PixelFormat format, int samples) {
        if (!cached.matches(size, samples)) cached = RenderTarget(size, format, samples);
        return cached;
    }

    RenderTarget image, sample, sum, bodies;
    int samplesInSum = 0;
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
    state.frame = frameBlock(view, *state.scene.scene(), state.summary.bounds, {});
    state.drawShadows(view, {});
    const int samples = view.settings.msaa > 0 ? view.settings.msaa : isSoftware() ? 1 : 4;
    RenderTarget& target = state.target(state.image, view.size, PixelFormat::Colour, samples);
    target.bind();
    state.drawImage(view);
    copyColours(target.framebuffer(), framebuffer, view.size);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

void Renderer::addSample(const RenderView& view, int index) {
    State& state = *m_state;
    const LightSample light = lightSample(index);
    state.frame = frameBlock(view, *state.scene.scene(), state.summary.bounds, light);
    state.drawShadows(view, light);
    RenderTarget& sample = state.target(state.sample, view.size, PixelFormat::Colour, 1);
    sample.bind();
    state.drawImage(view);
    state.target(state.sum, view.size, PixelFormat::Float, 1).bind();
    if (index > 0) glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    state.drawScaled(sample, 1.0f);
    glDisable(GL_BLEND);
    state.samplesInSum = index + 1;
}

void Renderer::drawMean(const RenderView& view, std::uint32_t framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, view.size.width, view.size.height);
    m_state->drawScaled(m_state->sum, 1.0f / static_cast<float>(m_state->samplesInSum));
}

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
