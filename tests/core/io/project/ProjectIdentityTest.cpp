#include "core/io/project/ProjectIdentity.h"

#include "core/asset/checks/VerifyProject.h"
#include "core/asset/library/StarterProject.h"
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class ProjectIdentityTest : public QObject {
    Q_OBJECT
private slots:
    void identitiesDifferAndAreValid() {
        Project project = starterProject();
        project.identity = newIdentity();
        QVERIFY(project.identity != newIdentity());
        QVERIFY(!verifyProject(project));
        QVERIFY(readProjectText(projectText(project)).value() == project);
    }
    void othersAreRefused() {
        for (const char* text : {"house", "0123456789ABCDEF0123456789ABCDEF", "0123456789abcdef0123456789abcdef0"}) {
            Project project = starterProject();
            project.identity = text;
            QVERIFY(verifyProject(project).value_or("").starts_with("The identity must have 32 hexadecimal digits"));
            QVERIFY(!readProjectText(projectText(project)));
        }
    }
};

RUBBLE_TEST(ProjectIdentityTest)
#include "ProjectIdentityTest.moc"
