#pragma once

#include "tests/support/Patience.h"
#include "viewport/widget/ViewportWidget.h"

#include <QImage>
#include <QTest>

namespace rubble::test {

/// The view as it is on screen once its picture, which comes from another thread, shows the scene as it is now. Null if
/// it never does.
inline QImage shownPicture(ViewportWidget& viewport) {
    const bool isCurrent = QTest::qWaitFor([&] { return viewport.isPictureCurrent(); }, kPatience);
    return isCurrent ? viewport.grab().toImage() : QImage();
}

/// The same once it will not be refined any further.
inline QImage finishedPicture(ViewportWidget& viewport) {
    const bool isFinished = QTest::qWaitFor([&] { return viewport.isPictureFinished(); }, kPatience);
    return isFinished ? viewport.grab().toImage() : QImage();
}

}  // namespace rubble::test
