#include "editor/widgets/ScreenFit.h"

#include <QScreen>
#include <QWidget>

namespace rubble {
namespace {

constexpr double kMaxScreenFraction = 0.9;  // of what panels leave: window managers add a frame of unknown size

}  // namespace

void resizeWithinScreen(QWidget& window, QSize size) {
    window.resize(size.boundedTo(window.screen()->availableSize() * kMaxScreenFraction));
}

}  // namespace rubble
