#include "viewport/render/Renderer.h"

#include "viewport/render/PicturePainter.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace rubble {
namespace {

constexpr int kPickReach = 64;  // pixels around the pointer that are drawn at once, since it will move on

}  // namespace

/// What is drawn to, beside what draws.
struct Renderer::State : PicturePainter {
    using PicturePainter::PicturePainter;

    /// The kept target, made anew where it is not like this.
    RenderTarget& target(RenderTarget& kept, PictureSize size, PixelFormat format, int samples) {
        if (!kept.isLike(size, samples)) kept = RenderTarget(size, format, samples);
        return kept;
    }

    RenderTarget picture, sample, sum, bodies;
    int samplesTaken = 0;                // in `sum`
    std::optional<Camera> bodiesCamera;  // that `bodies` was drawn by
    double bodiesMoment = 1.0;           // and at
    PixelBox bodiesPart;                 // where it was
};

Result<std::unique_ptr<Renderer>> Renderer::made() {
    if (epoxy_gl_version() < 33 || !epoxy_is_desktop_gl()) {
        const int version = epoxy_gl_version();
        return Error{ErrorCode::Unsupported, "Drawing needs OpenGL 3.3; this machine offers " +
                                                 std::to_string(version / 10) + "." + std::to_string(version % 10) +
                                                 "."};
    }
    Result<RenderPrograms> programs = madePrograms();
    if (!programs) return programs.error();
    return std::unique_ptr<Renderer>(new Renderer(std::make_unique<State>(std::move(*programs))));
}

Renderer::Renderer(std::unique_ptr<State> state) : m_state(std::move(state)) {}
Renderer::~Renderer() = default;

void Renderer::setScene(std::shared_ptr<const RenderScene> scene) {
    m_state->setScene(std::move(scene));
    m_state->bodiesCamera.reset();
}

void Renderer::draw(const PictureView& view, std::uint32_t framebuffer) {
    State& state = *m_state;
    state.frame = frameBlock(view, *state.scene.scene(), state.summary.bounds, {});
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
    state.frame = frameBlock(view, *state.scene.scene(), state.summary.bounds, light);
    state.drawShadows(view, light);
    RenderTarget& sample = state.target(state.sample, view.size, PixelFormat::Colour, 1);
    sample.bind();
    state.drawPicture(view);
    state.target(state.sum, view.size, PixelFormat::Float, 1).bind();
    if (index > 0) glEnable(GL_BLEND);
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

const RenderCounts& Renderer::counts() const { return m_state->scene.counts(); }

bool Renderer::isSoftware() const {
    const std::string_view name(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    return name.find("llvmpipe") != name.npos || name.find("softpipe") != name.npos;
}

std::optional<std::uint32_t> Renderer::bodyAt(const PictureView& view, int x, int y) {
    State& state = *m_state;
    if (x < 0 || y < 0 || x >= view.size.width || y >= view.size.height) return std::nullopt;
    const int up = view.size.height - 1 - y;
    const bool isKept = state.bodies.isLike(view.size, 1) && state.bodiesCamera == view.camera &&
                        state.bodiesMoment == view.moment && state.bodiesPart.contains(x, up);
    state.target(state.bodies, view.size, PixelFormat::BodyIndex, 1).bind();
    if (!isKept) {
        state.bodiesPart = {x - kPickReach, up - kPickReach, 2 * kPickReach + 1, 2 * kPickReach + 1};
        state.drawBodies(view, state.bodiesPart);
        state.bodiesCamera = view.camera;
        state.bodiesMoment = view.moment;
    }
    std::uint32_t body = 0;
    glReadPixels(x, up, 1, 1, GL_RED_INTEGER, GL_UNSIGNED_INT, &body);
    if (body == 0) return std::nullopt;
    return body - 1;
}

}  // namespace rubble
