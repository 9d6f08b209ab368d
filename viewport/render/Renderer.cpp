#include "viewport/render/Renderer.h"

#include "viewport/render/RenderPasses.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

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

    bool drawPicture(const RenderView& view, const LightSample& light, bool isSingle, RenderTarget& target);
    void drawHovered(const RenderView& view, std::uint32_t framebuffer);

    RenderTarget image, sample, sum, depths;
    int samplesInSum = 0;
    std::optional<RenderView> depthsView;  // of the content of `depths`
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
    m_state->depthsView.reset();
}

void Renderer::setTextureListener(std::function<void()> listener) {
    m_state->scene.textures().setListener(std::move(listener));
}
bool Renderer::updateTextures() { return m_state->scene.textures().update(); }
bool Renderer::areTexturesPending() const { return m_state->scene.textures().isPending(); }

void Renderer::setInterruption(std::function<bool()> isInterrupted) {
    m_state->scene.setInterruption(std::move(isInterrupted));
}

/// Shadows, light and the image itself; false if it was interrupted.
bool Renderer::State::drawPicture(const RenderView& view, const LightSample& light, bool isSingle,
                                  RenderTarget& target) {
    scene.restart();
    setShadows(view, light, isSingle);
    if (!scene.isInterrupted()) setLight(view);
    if (!scene.isInterrupted()) {
        target.bind();
        drawImage(view);
    }
    if (!scene.isInterrupted()) return true;
    invalidateShadows();
    return false;
}

bool Renderer::draw(const RenderView& view, std::uint32_t framebuffer) {
    State& state = *m_state;
    const RenderView drawn = atResolution(view);
    const int wanted = view.settings.msaa > 0 ? view.settings.msaa : isSoftware() ? 1 : 4;
    const int samples = drawn.size == view.size ? wanted : 1;  // several cannot be scaled
    RenderTarget& target = state.target(state.image, drawn.size, PixelFormat::Colour, samples);
    state.setSky(drawn.settings);
    if (!state.drawPicture(drawn, singleSample(state.skyLight.sky), true, target)) return false;
    drawAgain(view, framebuffer);
    return true;
}

void Renderer::drawAgain(const RenderView& view, std::uint32_t framebuffer) {
    m_state->image.copyColours(framebuffer, view.size);
    m_state->drawHovered(view, framebuffer);
}

bool Renderer::addSample(const RenderView& view, int index) {
    State& state = *m_state;
    RenderTarget& target = state.target(state.sample, view.size, PixelFormat::Colour, 1);
    state.setSky(view.settings);
    if (!state.drawPicture(view, lightSample(state.skyLight.sky, index), false, target)) return false;
    state.target(state.sum, view.size, PixelFormat::Float, 1).bind();
    if (index > 0) glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    state.drawScaled(state.sample, 1.0f);
    glDisable(GL_BLEND);
    state.samplesInSum = index + 1;
    return true;
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
    scene.restart();
    const FrameBlock before = frame;
    setFrame(frameBlock(view, *scene.scene(), summary, skyLight, singleSample(skyLight.sky)));
    frame.hovered.x = *view.hovered + 1;
    setFrame(frame);
    RenderView same = view;
    same.hovered.reset();
    if (depthsView != same) {
        target(depths, view.size, PixelFormat::Colour, 1).bind();
        drawDepths(kAllSurfaces);
        depthsView = same;
    }
    outlines.draw(scene, view,
                  {.outlined = box, .depths = depths.framebuffer(), .image = framebuffer, .isHovered = true});
    setFrame(before);
}

void Renderer::finish() { glFinish(); }

const RenderCounts& Renderer::counts() const { return m_state->scene.counts(); }

bool Renderer::isSoftware() const {
    const std::string_view name(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    return name.find("llvmpipe") != name.npos || name.find("softpipe") != name.npos;
}

}  // namespace rubble
