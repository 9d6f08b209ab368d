#include "tests/support/Sessions.h"
#include "viewport/film/SheetPicture.h"

#include <QTest>

#include <map>

namespace rubble::test {
namespace {

constexpr SheetLook kSmall{.size = {64, 48}, .samples = 0};

SheetOrder orderOf(std::uint32_t count, bool isStaged) {
    SheetOrder order{.project = floatingBlock()};
    const Id shot = addShot(order.project, "box", 0.0, throwAtBlock(5.0, 40.0));
    order.asset = order.project.assets[0].id;
    order.variants = variantsOf(order.project.assets[0], {.count = count}).value();
    if (isStaged) order.stage = SheetStage{.shots = {shot}, .step = 20};
    return order;
}

std::map<std::uint32_t, std::optional<Image>> drawn(const SheetOrder& order, const SheetLook& look, int threads = 1) {
    std::map<std::uint32_t, std::optional<Image>> pictures;
    const auto take = [&](SheetEntry entry, std::optional<Image> picture) {
        if (entry.moment) qFatal("the moment was kept");
        pictures[entry.number] = std::move(picture);
    };
    const Status status = drawContactSheet(order, look, take, {.threads = threads});
    if (!status) qFatal("%s", status.error().message.c_str());
    return pictures;
}

}  // namespace

class SheetPictureTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (!PictureMaker::made()) QSKIP("There is no OpenGL here.");
    }
    void everyVariantIsDrawnInItsSize() {
        for (const bool isStaged : {false, true}) {
            const auto pictures = drawn(orderOf(3, isStaged), kSmall);
            QCOMPARE(pictures.size(), std::size_t{3});
            for (const auto& [number, picture] : pictures) {
                QVERIFY(picture && picture->width == 64 && picture->height == 48);
            }
            QVERIFY(pictures.at(1)->pixels != pictures.at(2)->pixels);
        }
    }
    void theSameOnAnyNumberOfThreads() {
        const auto one = drawn(orderOf(4, true), kSmall), three = drawn(orderOf(4, true), kSmall, 3);
        for (const auto& [number, picture] : one) QVERIFY(picture->pixels == three.at(number)->pixels);
    }
    void oneWithAFaultHasNoPicture() {
        SheetOrder order = orderOf(3, false);
        order.variants[1].prism.depth = -1.0;
        const auto pictures = drawn(order, kSmall);
        QVERIFY(pictures.at(0) && !pictures.at(1) && pictures.at(2));
    }
    void darkIsDarkerThanLight() {
        SheetLook dark = kSmall;
        dark.theme = Theme::Dark;
        const SheetOrder order = orderOf(1, false);
        QVERIFY(drawn(order, dark).at(0)->pixels[0] < drawn(order, kSmall).at(0)->pixels[0]);
    }
    void faultsAndCancellationAreHandedOn() {
        const auto ignore = [](const SheetEntry&, const std::optional<Image>&) {};
        SheetOrder order = orderOf(2, true);
        order.stage->shots = {99};
        QVERIFY(drawContactSheet(order, kSmall, ignore).error().code == ErrorCode::NotFound);
        SheetLook none = kSmall;
        none.size = {0, 0};
        QVERIFY(drawContactSheet(orderOf(2, false), none, ignore).error().code == ErrorCode::BadInput);
        const TaskContext task;
        task.cancel.cancel();
        QVERIFY(drawContactSheet(orderOf(2, false), kSmall, ignore, task).error().code == ErrorCode::Cancelled);
    }
};

}  // namespace rubble::test

QTEST_GUILESS_MAIN(rubble::test::SheetPictureTest)
#include "SheetPictureTest.moc"
