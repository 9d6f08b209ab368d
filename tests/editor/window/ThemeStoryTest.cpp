// Tests editor/workspace/ViewportStyle.cpp and all else that has the colours of the theme: in an open window, each view
// has the new colours at once, without a restart.
#include "core/asset/library/StarterProject.h"
#include "editor/dialogs/sheet/ContactSheetWindow.h"
#include "editor/help/ManualWindow.h"
#include "editor/view3d/PlayView.h"
#include "editor/widgets/ColourScheme.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/viewport/ShownPicture.h"

#include <QDockWidget>
#include <QListWidget>
#include <QTextBrowser>
#include <QToolButton>

#include <utility>

using namespace rubble;

namespace {

/// The mean lightness of a picture, in [0, 255].
double lightness(const QImage& picture) {
    double sum = 0.0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) sum += picture.pixelColor(x, y).lightness();
    }
    return sum / (picture.width() * picture.height());
}

}  // namespace

class ThemeStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void init() {
        open(starterProject());
        setTheme(ColourScheme::Light);
        QTRY_VERIFY_WITH_TIMEOUT(window().workspace().bakes().areCurrent(project()), kPatience);
    }
    void cleanup() { close(); }

    void viewsFollowThePreferences_data() {
        QTest::addColumn<QString>("view");
        for (const char* view : {"canvas", "scene", "play", "dock"}) QTest::newRow(view) << QString(view);
    }
    void viewsFollowThePreferences() {
        QFETCH(QString, view);
        if (!hasView()) QSKIP("There is no OpenGL here.");
        if (view == "play") {
            QTest::keyClick(&window(), Qt::Key_P, Qt::ControlModifier);
            QTRY_VERIFY_WITH_TIMEOUT(window().workspace().play().isPlaying(), kPatience);
        }
        QWidget& shown = view == "canvas" ? canvas() : view == "dock" ? dock() : static_cast<QWidget&>(viewport());
        followsTheme([&] { return picture(shown); });
    }
    void viewsFollowThePalette() {
        if (!hasView()) QSKIP("There is no OpenGL here.");
        for (QWidget* view : {static_cast<QWidget*>(&viewport()), static_cast<QWidget*>(&canvas())}) {
            window().setPalette(lightPalette());
            const double light = lightness(picture(*view));
            window().setPalette(darkPalette());
            QVERIFY(lightness(picture(*view)) < light - 40.0);
        }
    }
    /// The desktop of the tests is light.
    void themeOfTheDesktopIsReadAgain() {
        for (const auto& [theme, isDarkAfter] : {std::pair(ColourScheme::System, false), {ColourScheme::Dark, true}}) {
            setTheme(theme);
            QApplication::setPalette(darkPalette());
            QEvent changed(QEvent::ThemeChange);
            QCoreApplication::sendEvent(&window(), &changed);
            QCOMPARE(isDark(QApplication::palette()), isDarkAfter);
        }
    }
    void picturesOfVariantsFollow() {
        if (!hasView()) QSKIP("There is no OpenGL here.");
        ContactSheetWindow sheet(window().workspace(), {}, &window());
        sheet.show();
        sheet.generate();
        const auto picture = [&]() -> QImage {
            if (sheet.list().count() == 0) return {};
            return sheet.list().item(0)->icon().pixmap(240, 180).toImage();
        };
        followsTheme(picture);
    }
    void picturesOfTheStartPageFollow() {
        std::unique_ptr<MainWindow> start(new MainWindow(emptyProject(), preferences(), m_recentFiles));
        start->show();
        QVERIFY(QTest::qWaitForWindowExposed(start.get(), kPatience));
        int pictures = 0;
        for (QToolButton* button : start->centralWidget()->findChildren<QToolButton*>()) {
            if (button->icon().isNull() || button->iconSize().width() < 150) continue;
            ++pictures;
            followsTheme([&] { return button->icon().pixmap(button->iconSize()).toImage(); });
            followsTheme([&] { return button->grab().toImage(); });
        }
        QVERIFY(pictures >= 3);
        followsTheme([&] { return start->grab().toImage(); });
    }
    void manualFollows() {
        ManualWindow manual(RUBBLE_SOURCE_DIR "/docs/manual");
        manual.show();
        followsTheme([&] { return manual.grab().toImage(); });
    }

private:
    static QImage picture(QWidget& widget) {
        auto* view = qobject_cast<ViewportWidget*>(&widget);
        return view != nullptr ? test::shownPicture(*view) : widget.grab().toImage();
    }
    void setTheme(ColourScheme theme) {
        Preferences changed = preferences().preferences();
        changed.theme = theme;
        preferences().setPreferences(changed);
    }
    /// Light, then dark, then light again as before.
    template <class Picture>
    void followsTheme(const Picture& picture) {
        setTheme(ColourScheme::Light);
        QTRY_VERIFY_WITH_TIMEOUT(lightness(picture()) > 140.0, kPatience);
        const double light = lightness(picture());
        setTheme(ColourScheme::Dark);
        QTRY_VERIFY_WITH_TIMEOUT(!picture().isNull() && lightness(picture()) < light - 40.0, kPatience);
        setTheme(ColourScheme::Light);
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(lightness(picture()) - light) < 6.0, kPatience);
    }
    QWidget& dock() { return window().views().docks().dock(DockId::Inspector); }

    RecentFiles m_recentFiles;
};

RUBBLE_TEST_WITH(ThemeStoryTest, QApplication)
#include "ThemeStoryTest.moc"
