#pragma once

#include "core/geometry/polygon/OutlineShapes.h"
#include "editor/background/Baker.h"
#include "editor/canvas/tools/SeedTool.h"
#include "editor/canvas/widget/PatternCanvas.h"
#include "editor/commands/ProjectEdits.h"
#include "tests/support/Patience.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

namespace rubble {

/// A project with one asset: a prism with one layer.
inline Project projectOf(const Polygon& outline, LayerParameters parameters) {
    Project project;
    project.nextId = 10;
    project.materials = {{.id = 1, .name = "stone"}};
    Asset asset = boxAsset(2, 3, std::move(parameters));
    asset.prism().outline = outline;
    project.assets = {asset};
    return project;
}

/// A canvas on a document with background baking, as in the editor.
struct CanvasBench {
    explicit CanvasBench(Project project) : document(std::move(project)) {
        selection.prune(document.project());
        canvas.resize(640, 480);
        canvas.show();
        settle();
    }

    const Asset& asset() const { return document.project().assets.front(); }
    /// Waits until the canvas shows the current pattern.
    void settle() {
        QVERIFY(QTest::qWaitFor([&] { return isSettled(); }, kPatience));
        QCoreApplication::processEvents();
    }
    bool isSettled() const {
        const auto pattern = bakes.findPattern(asset().id);
        return pattern && *pattern->asset == asset();
    }

    QPoint pixels(Vec2 metres) const { return canvas.view().pixels(metres).toPoint(); }
    /// The centre of the pixel nearest to a point, m.
    Vec2 metres(Vec2 point) const { return canvas.view().metres(pixels(point)); }
    Vec2 seedAt(std::size_t seed) const { return canvas.displayedPattern()->seeds().positions[seed]; }
    SeedId seedId(std::size_t seed) const { return canvas.displayedPattern()->seeds().ids[seed]; }

    /// An edit that is not of the canvas.
    void renameAsset(const std::string& name) {
        Asset renamed = asset();
        renamed.name = name;
        document.push(modify("Rename", std::move(renamed)));
    }

    void click(Vec2 at, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseMove(&canvas, pixels(at));
        QTest::mouseClick(&canvas, Qt::LeftButton, modifiers, pixels(at));
        settle();
    }
    void drag(Vec2 from, Vec2 to, Qt::KeyboardModifiers modifiers = {}) {
        press(from, modifiers);
        moveTo((from + to) / 2.0, modifiers);
        moveTo(to, modifiers);
        release(to, modifiers);
    }
    void press(Vec2 at, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseMove(&canvas, pixels(at));
        QTest::mousePress(&canvas, Qt::LeftButton, modifiers, pixels(at));
    }
    void moveTo(Vec2 at, Qt::KeyboardModifiers modifiers = {}) {
        const QPointF position(pixels(at));
        QMouseEvent event(QEvent::MouseMove, position, canvas.mapToGlobal(position), Qt::NoButton, Qt::LeftButton,
                          modifiers);
        QCoreApplication::sendEvent(&canvas, &event);
    }
    void release(Vec2 at, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseRelease(&canvas, Qt::LeftButton, modifiers, pixels(at));
        settle();
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&canvas, key, modifiers);
        settle();
    }

    Document document;
    Selection selection;
    Bakes bakes;
    Baker baker{document, selection, bakes};
    BondPainter bondPainter{document, selection};
    PatternCanvas canvas{document, selection, bakes, bondPainter};
};

}  // namespace rubble
