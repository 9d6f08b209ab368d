#include "editor/widgets/ScreenFit.h"

#include <QScreen>
#include <QWidget>

#include <algorithm>

namespace rubble {
namespace {

constexpr double kMaxScreenFraction = 0.9;  // of what panels leave: window managers add a frame of unknown size

constexpr QPoint kCascadeStep{30, 30};       // the height of a title
constexpr double kMinCascadeFraction = 0.8;  // of the size of a window that is made smaller

}  // namespace

void resizeWithinScreen(QWidget& window, QSize size) {
    window.resize(size.boundedTo(window.screen()->availableSize() * kMaxScreenFraction));
}

QRect cascaded(QSize size, QSize least, const QRect& over, const QList<QRect>& others, const QRect& available) {
    QPoint at = over.topLeft() + kCascadeStep;
    const auto isTaken = [&](const QRect& other) {
        return (other.topLeft() - at).manhattanLength() < kCascadeStep.x();
    };
    for (qsizetype k = 0; k < others.size() && std::ranges::any_of(others, isTaken); ++k) at += kCascadeStep;
    const QSize smallest = least.expandedTo(size * kMinCascadeFraction);
    if (available.right() + 1 - at.x() < smallest.width()) at.setX(available.left());
    if (available.bottom() + 1 - at.y() < smallest.height()) at.setY(available.top());
    return QRect(at, size) & available;
}

}  // namespace rubble
