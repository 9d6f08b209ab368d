#include "editor/background/VideoEstimate.h"

#include "viewport/render/OffscreenRenderer.h"

#include <algorithm>
#include <chrono>

namespace rubble {

namespace {

constexpr int kMeasuredSamples = 2;  // of a frame, in place of all

/// s, of a function.
template <class Function>
double secondsOf(Function function) {
    const auto start = std::chrono::steady_clock::now();
    function();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Frames are encoded while the next ones are rendered.
Result<double> measuredFrame(const std::shared_ptr<const RenderScene>& scene, const RenderView& view, int samples,
                             const TaskContext& task) {
    Result<OffscreenRenderer> renderer = OffscreenRenderer::create();
    if (!renderer) return renderer.error();
    const int measured = std::min(samples, kMeasuredSamples);
    const Result<Image> first = renderer->renderImage(scene, view, measured, task);  // uploads the geometry
    if (!first) return first.error();
    Result<Image> frame = first;
    const double pass = secondsOf([&] { frame = renderer->renderImage(scene, view, measured, task); });
    if (!frame) return frame.error();
    const double rendering = measured > 0 ? pass / measured * samples : pass;
    return std::max(rendering, secondsOf([&] { static_cast<void>(pngOf(*frame, PngEffort::Quick)); }));
}

}  // namespace

VideoEstimate::VideoEstimate(QObject* parent) : QObject(parent) {}

void VideoEstimate::measure(const std::shared_ptr<const RenderScene>& scene, const RenderView& view, int samples) {
    m_secondsPerFrame.reset();
    m_job.start([=](const TaskContext& task) { return measuredFrame(scene, view, samples, task); },
                [this](const Result<double>& seconds) {
                    if (seconds) m_secondsPerFrame = *seconds;
                    emit changed();
                });
    emit changed();
}

}  // namespace rubble

#include "moc_VideoEstimate.cpp"
