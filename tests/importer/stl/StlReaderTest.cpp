// Tests app/importer/stl/StlReader.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/files/MeshCases.h"

using namespace rubble;

class StlReaderTest : public QObject {
    Q_OBJECT
private slots:
    void everyMeshIsWhatItsValuesSay_data() { test::addMeshCases({".stl"}); }
    void everyMeshIsWhatItsValuesSay() {
        QFETCH(const QString, file);
        test::compareMeshCase(file.toStdString());
    }
};

RUBBLE_TEST(StlReaderTest)
#include "StlReaderTest.moc"
