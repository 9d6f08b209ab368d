// Measures the latency of dragging a seed, from the mouse event until its new cells are painted, against repainting the
// canvas. Percentiles of many mouse moves. Runs without a display.
#include "bench/BoxAssets.h"
#include "core/base/Percentile.h"
#include "editor/background/Baker.h"
#include "editor/canvas/widget/PatternCanvas.h"

#include <QApplication>
#include <QMouseEvent>

#include <chrono>
#include <cstdio>
#include <vector>

using namespace rubble;

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kWarmUps = 20;
constexpr int kMoves = 300;
constexpr int kPaints = 40;
constexpr QSize kCanvas(1280, 800);  // pixels

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// A canvas that records what it painted last.
class WatchedCanvas : public PatternCanvas {
public:
    using PatternCanvas::PatternCanvas;
    std::optional<Asset> painted;  // the asset whose cells were painted

protected:
    void paintEvent(QPaintEvent* event) override {
        PatternCanvas::paintEvent(event);
        if (displayedAsset()) painted = *displayedAsset();
    }
};

/// A canvas with a document and a background baker.
class CanvasSession {
public:
    explicit CanvasSession(std::uint32_t seeds) : m_document(bench::wallProject(seeds)) {
        m_selection.prune(m_document.project());
        m_canvas.resize(kCanvas);
        m_canvas.show();
        waitFor([&] { return isShown() && !m_baker.isBusy(); });
    }

    /// Times a full repaint, as after a zoom.
    std::vector<double> paintAll() {
        std::vector<double> times;
        for (int k = 0; k < kPaints; ++k) {
            CanvasView view = m_canvas.view();
            view.scale *= k % 2 == 0 ? 1.0 + 1e-9 : 1.0 - 1e-9;
            const auto start = Clock::now();
            m_canvas.setView(view);
            m_canvas.repaint();
            times.push_back(millisecondsSince(start));
        }
        return times;
    }

    /// Times a repaint from the backing store, as after an expose.
    std::vector<double> paintCached() {
        std::vector<double> times;
        for (int k = 0; k < kPaints; ++k) {
            const auto start = Clock::now();
            m_canvas.repaint();
            times.push_back(millisecondsSince(start));
        }
        return times;
    }

    std::vector<double> drag() {
        const Vec2 seed =
            m_canvas.displayedPattern()->seeds().positions[m_canvas.displayedPattern()->nearestSeed({}, 1.0)];
        const QPointF from = m_canvas.view().pixels(seed);
        send(QEvent::MouseButtonPress, from);
        std::vector<double> times;
        for (int k = 0; k < kWarmUps + kMoves; ++k) {
            const QPointF to = from + QPointF(20.0 + (k * 7) % 31, (k * 5) % 23);
            const auto start = Clock::now();
            send(QEvent::MouseMove, to);
            waitFor([&] { return isShown(); });
            if (k >= kWarmUps) times.push_back(millisecondsSince(start));
        }
        send(QEvent::MouseButtonRelease, from);
        return times;
    }

private:
    void send(QEvent::Type type, QPointF at) {
        const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
        QMouseEvent event(type, at, m_canvas.mapToGlobal(at), button, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&m_canvas, &event);
    }
    /// Whether the current state of the asset was painted.
    bool isShown() const { return m_canvas.painted && *m_canvas.painted == asset(); }
    const Asset& asset() const { return m_document.project().assets.front(); }
    template <class Condition>
    void waitFor(Condition isMet) {
        while (!isMet()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
    }

    Document m_document;
    Selection m_selection;
    Bakes m_bakes;
    Baker m_baker{m_document, m_selection, m_bakes};
    WatchedCanvas m_canvas{m_document, m_selection, m_bakes};
};

void measure(std::uint32_t seeds) {
    CanvasSession session(seeds);
    const double all = percentile(session.paintAll(), 0.5);
    const double cached = percentile(session.paintCached(), 0.5);
    const std::vector<double> drag = session.drag();
    const double median = percentile(drag, 0.5);
    std::printf("| %u | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f |\n", seeds, all, cached, median,
                percentile(drag, 0.9), percentile(drag, 0.99), median / all, median / cached);
}

}  // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication program(argc, argv);
    std::vector<std::uint32_t> counts;
    for (const QString& argument : QApplication::arguments().mid(1)) counts.push_back(argument.toUInt());
    if (counts.empty()) counts = {20, 1'000, 20'000};
    std::printf(
        "| seeds | full repaint, ms | cached repaint, ms | drag to new cells, ms | 90 %% | 99 %% "
        "| drag : full | drag : cached |\n| --- | --- | --- | --- | --- | --- | --- | --- |\n");
    for (const std::uint32_t seeds : counts) measure(seeds);
    return 0;
}
