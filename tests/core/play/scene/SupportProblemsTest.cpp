#include "core/play/scene/SupportProblems.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Arcade.h"
#include "tests/support/play/BondedWalls.h"
#include "tests/support/play/MortarPortal.h"

using namespace rubble;

class SupportProblemsTest : public QObject {
    Q_OBJECT
private slots:
    /// The middle of the lintel is 1.5 m from both piers.
    void fragmentsBeyondTheSpanAreReported() {
        for (const double span : {0.0, 1.6})
            QVERIFY(supportProblems(*test::playSceneOf(test::bondedPortal(span, 0.0))).empty());
        const auto scene = test::playSceneOf(test::bondedPortal(0.7, 0.0));
        const std::vector<Diagnostic> problems = supportProblems(*scene);
        QCOMPARE(problems.size(), std::size_t{1});
        const Diagnostic& problem = problems[0];
        QCOMPARE(problem.code, DiagnosticCode::BeyondSpan);
        QVERIFY(problem.limit == 0.7 && problem.value > 0.7 && problem.value < 1.6);
        const PlayStructure& portal = *scene->structures.begin()->second;
        const Vec3 centre = portal.graph.centres[problem.place.fragment];
        QVERIFY2(std::abs(centre.x) < 0.8, QByteArray::number(centre.x));
        QCOMPARE(portal.asset->bake->fragmentPath(problem.place.fragment), problem.place.path);
        QVERIFY(problem.place.fragments.size() > 1);
        QVERIFY(problem.place.fragments == nodesBeyondSpan(portal));  // one node for each fragment here
        QVERIFY(problem.message.starts_with("Instance \"wall\": "));
        QVERIFY(scene->diagnostics == problems);
        for (const std::uint32_t node : nodesBeyondSpan(portal)) QVERIFY(std::abs(portal.graph.centres[node].x) < 1.0);
    }
    void whatGravityDoesNotPullNeedsNoSupport() {
        Project project = test::bondedPortal(0.7, 0.0);
        project.gravity = Vec3(0.0);
        QVERIFY(supportProblems(*test::playSceneOf(project)).empty());
        project.gravity = {0.0, -9.81, 0.0};
        project.instances[0].isAnchored = false;  // it falls as one
        QVERIFY(supportProblems(*test::playSceneOf(project)).empty());
    }
    void whatHangsOnMortarIsReported() {
        Project project = test::mortarPortal();
        for (Instance& instance : project.instances) instance.isAnchored = false;
        project.instances[2].isAnchored = project.instances[2].isFixed = true;
        Asset& pier = project.assets[0];
        pier.bonding.span = 1.0;
        project.ground.isOn = false;
        const std::vector<Diagnostic> problems = supportProblems(*test::playSceneOf(project));
        QCOMPARE(problems.size(), std::size_t{2});
        QVERIFY(problems[0].message.find("has no support from below or from a side") != std::string::npos);
    }
    void sceneProblemsAreOnlyThoseOfSupport() {
        Project project = test::mortarPortal();
        for (Instance& instance : project.instances) instance.isAnchored = false;
        const AssetBakes bakes = *bakesOf(project);
        const std::vector<Diagnostic> problems = sceneProblems(project, bakes);
        QCOMPARE(problems.size(), std::size_t{1});
        QCOMPARE(problems[0].code, DiagnosticCode::IdleMortar);
        QVERIFY(sceneProblems(project, {}).empty());  // it cannot be played yet
        project.mortars.clear();
        QVERIFY(!mayHaveSceneProblems(project));
    }
    void theDemoHasNone() { QVERIFY(supportProblems(*test::playSceneOf(test::arcade())).empty()); }
};

RUBBLE_TEST(SupportProblemsTest)
#include "SupportProblemsTest.moc"
