// Tests app/importer/obj/*.cpp and app/importer/files/TextWords.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/files/MeshCases.h"

using namespace rubble;

class ObjReaderTest : public QObject {
    Q_OBJECT
private slots:
    void everyMeshIsWhatItsValuesSay_data() { test::addMeshCases({".obj"}); }
    void everyMeshIsWhatItsValuesSay() {
        QFETCH(const QString, file);
        test::compareMeshCase(file.toStdString());
    }
};

RUBBLE_TEST(ObjReaderTest)
#include "ObjReaderTest.moc"
