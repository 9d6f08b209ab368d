#include "viewport/render/AxesIndicator.h"

#include "tests/support/TestProgram.h"

#include <algorithm>

using namespace rubble;

class AxesIndicatorTest : public QObject {
    Q_OBJECT
private slots:
    void axesPointWhereTheCameraSeesThem() {
        const std::vector<ScreenLine> lines = axesIndicator(Camera{}, 1.0);
        QVERIFY(lines.size() >= 3);
        for (const ScreenLine& line : lines) {
            for (int k = 0; k < 4; ++k) QVERIFY(line.ends[k] > 0.0f && line.ends[k] < 200.0f);  // in the corner
        }
        const auto green = std::ranges::find_if(lines, [](const ScreenLine& line) {
            return line.colour.y > line.colour.x && line.colour.y > line.colour.z;
        });
        QVERIFY(green != lines.end());
        QVERIFY(green->ends.w > green->ends.y || green->ends.y > green->ends.w);  // y is not seen end on
    }
    void indicatorGrowsWithTheScale() {
        const auto right = [](double scale) {
            float most = 0.0f;
            for (const ScreenLine& line : axesIndicator(Camera{}, scale))
                most = std::max({most, line.ends.x, line.ends.z});
            return most;
        };
        QVERIFY(std::abs(right(2.0) - 2.0f * right(1.0)) < 1.0f);
    }
};

RUBBLE_TEST(AxesIndicatorTest)
#include "AxesIndicatorTest.moc"
