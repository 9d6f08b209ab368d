#pragma once

#include <QImage>

#include <cstdlib>

namespace rubble::test {

/// Of 255, in the mean over all pixels and channels of two pictures of one size, three bytes a pixel.
inline double meanDifference(const QImage& a, const QImage& b) {
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y) {
        for (int k = 0; k < 3 * a.width(); ++k) sum += std::abs(a.constScanLine(y)[k] - b.constScanLine(y)[k]);
    }
    return sum / (3.0 * a.width() * a.height());
}

}  // namespace rubble::test
