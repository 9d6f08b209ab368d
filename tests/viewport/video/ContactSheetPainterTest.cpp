#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"
#include "viewport/video/ContactSheetPainter.h"

#include <QTest>

#include <map>

namespace rubble::test {
namespace {

constexpr SheetStyle kSmall{.size = {64, 48}, .samples = 0};

SheetRequest orderOf(std::uint32_t count, bool isStaged) {
    SheetRequest request{.project = floatingBlock()};
    const Id shot = addShot(request.project, "box", 0.0, throwAtBlock(5.0, 40.0));
    request.asset = request.project.assets[0].id;
    request.variants = generateVariants(request.project.assets[0], {.count = count}).value();
    if (isStaged) request.stage = SheetStage{.shots = {shot}, .step = 20};
    return request;
}

std::map<std::uint32_t, std::optional<Image>> drawn(const SheetRequest& request, const SheetStyle& look,
                                                    int threads = 1) {
    std::map<std::uint32_t, std::optional<Image>> pictures;
    const auto take = [&](SheetEntry entry, std::optional<Image> picture) {
        if (entry.session) qFatal("the session was kept");
        pictures[entry.number] = std::move(picture);
    };
    const Status status = drawContactSheet(request, look, take, {.threads = threads});
    if (!status) qFatal("%s", status.error().message.c_str());
    return pictures;
}

}  // namespace

class ContactSheetPainterTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (!OffscreenRenderer::create()) QSKIP("There is no OpenGL here.");
    }
    void everyVariantHasTheRequestedSize() {
        for (const bool isStaged : {false, true}) {
            const auto pictures = drawn(orderOf(3, isStaged), kSmall);
            QCOMPARE(pictures.size(), std::size_t{3});
            for (const auto& [number, picture] : pictures) {
                QVERIFY(picture && picture->width == 64 && picture->height == 48);
            }
            QVERIFY(pictures.at(1)->pixels != pictures.at(2)->pixels);
        }
    }
    void imagesDoNotDependOnThreadCount() {
        const auto one = drawn(orderOf(4, true), kSmall), three = drawn(orderOf(4, true), kSmall, 3);
        for (const auto& [number, picture] : one) QVERIFY(picture->pixels == three.at(number)->pixels);
    }
    void faultyVariantHasNoImage() {
        SheetRequest request = orderOf(3, false);
        request.variants[1].prism().depth = -1.0;
        const auto pictures = drawn(request, kSmall);
        QVERIFY(pictures.at(0) && !pictures.at(1) && pictures.at(2));
    }
    void darkThemeIsDarker() {
        SheetStyle dark = kSmall;
        dark.theme = Theme::Dark;
        const SheetRequest request = orderOf(1, false);
        QVERIFY(drawn(request, dark).at(0)->pixels[0] < drawn(request, kSmall).at(0)->pixels[0]);
    }
    void propagatesErrorsAndCancellation() {
        const auto ignore = [](const SheetEntry&, const std::optional<Image>&) {};
        SheetRequest request = orderOf(2, true);
        request.stage->shots = {99};
        QVERIFY(drawContactSheet(request, kSmall, ignore).error().code == ErrorCode::NotFound);
        SheetStyle none = kSmall;
        none.size = {0, 0};
        QVERIFY(drawContactSheet(orderOf(2, false), none, ignore).error().code == ErrorCode::BadInput);
        const TaskContext task;
        task.cancel.cancel();
        QVERIFY(drawContactSheet(orderOf(2, false), kSmall, ignore, task).error().code == ErrorCode::Cancelled);
    }
};

RUBBLE_TEST_WITH(ContactSheetPainterTest, QCoreApplication)

}  // namespace rubble::test

#include "ContactSheetPainterTest.moc"
