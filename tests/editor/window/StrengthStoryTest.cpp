// Tests editor/views/Views.cpp: what the docks Strength and Problems show in the views.
#include "core/play/analysis/RequirementShot.h"
#include "editor/panels/docks/ProblemPanel.h"
#include "editor/panels/docks/StrengthPanel.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/EditorStory.h"
#include "tests/support/play/BondedWalls.h"

#include <QToolButton>
#include <QTreeView>

using namespace rubble;

class StrengthStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void cleanup() { close(); }

    /// A hit on an instance, and a drop beside the house.
    void playingAnEventFramesWhatItActsOn() {
        openFile(RUBBLE_SOURCE_DIR "/projects/house.rubble");
        if (!hasView()) QSKIP("There is no OpenGL here.");
        viewport().setCameraAnimation(false);
        QTRY_VERIFY_WITH_TIMEOUT(window().workspace().bakes().areCurrent(project()), kPatience);
        const auto asset = std::ranges::find_if(project().assets, [](const Asset& one) {
            return one.requirements.size() == 2 && std::holds_alternative<HitRequirement>(one.requirements[0].event) &&
                   std::holds_alternative<DropRequirement>(one.requirements[1].event);
        });
        QVERIFY(asset != project().assets.end());
        selection().setAsset(asset->id);
        PlayController& play = window().workspace().play();
        play.thread().useSteppedClock();
        window().views().frameAsset();
        const double whole = viewport().camera().distance;
        const Instance* hit = instanceToTry(project(), *asset, asset->requirements[0], 0);
        QVERIFY(hit);
        playEvent(0);
        QVERIFY(viewport().camera().distance < 0.8 * whole);
        QVERIFY(viewport().rect().contains(viewport().pointOf(hit->pose.position)->toPoint()));
        QTRY_VERIFY_WITH_TIMEOUT(play.isPlaying(), kPatience);
        play.stop();
        playEvent(1);
        QVERIFY(viewport().camera().distance < 0.8 * whole);
        QTRY_VERIFY_WITH_TIMEOUT(play.isPlaying() && play.frame(), kPatience);
        play.thread().advance(kStep);
        play.applyUpdate();
        const Throw& dropped = std::get<Throw>(play.lastShot()->action);
        QVERIFY(viewport().rect().contains(viewport().pointOf(dropped.from)->toPoint()));
    }
    /// Those beyond the span of a portal.
    void enterOnAProblemSelectsAllItsFragments() {
        openBaked(test::bondedPortal(0.7, 0.0));
        QTreeView& list = window().findChild<ProblemPanel*>()->view();
        const auto rowOfSpan = [&] {
            for (int row = 0; row < list.model()->rowCount(); ++row) {
                if (list.model()->index(row, 0).data().toString() == "Beyond the span") return row;
            }
            return -1;
        };
        QTRY_VERIFY_WITH_TIMEOUT(rowOfSpan() >= 0, kPatience);
        const QModelIndex problem = list.model()->index(rowOfSpan(), 0);
        const std::vector<Diagnostic> all = window().workspace().problems().all();
        const auto beyond = std::ranges::find(all, DiagnosticCode::BeyondSpan, &Diagnostic::code);
        QVERIFY(beyond != all.end() && beyond->place.fragments.size() > 1);
        emit list.activated(problem);
        QCOMPARE(selection().seeds().size(), beyond->place.fragments.size());
    }

private:
    void playEvent(int row) {
        const auto buttons = [&] {
            return window().findChild<StrengthPanel*>()->findChildren<QToolButton*>("play-event");
        };
        QTRY_VERIFY_WITH_TIMEOUT(buttons().size() == 2 && buttons()[row]->isEnabled(), kPatience);
        buttons()[row]->click();
        QTRY_VERIFY_WITH_TIMEOUT(window().workspace().play().isInPlay(), kPatience);
    }
};

RUBBLE_TEST_WITH(StrengthStoryTest, QApplication)
#include "StrengthStoryTest.moc"
