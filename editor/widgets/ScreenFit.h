#pragma once

#include <QList>
#include <QRect>
#include <QSize>

class QWidget;

namespace rubble {

/// Resizes a window that is not shown yet, in points, but to no more than its screen holds beside its frame.
void resizeWithinScreen(QWidget& window, QSize size);

/// Returns where a window of this size lies below and right of the window `over`, and of others that lie there already,
/// so that their titles can be seen. All rectangles are in points. The result lies within `available`: it is a little
/// smaller than `size` where it has to be, but not than `least`, and starts again at the left or top where there is no
/// room for it.
QRect cascaded(QSize size, QSize least, const QRect& over, const QList<QRect>& others, const QRect& available);

}  // namespace rubble
