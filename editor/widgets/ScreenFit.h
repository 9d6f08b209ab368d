#pragma once

#include <QSize>

class QWidget;

namespace rubble {

/// Resizes a window that is not shown yet, in points, but to no more than its screen holds beside its frame.
void resizeWithinScreen(QWidget& window, QSize size);

}  // namespace rubble
