// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the pictures of the manual again; "cmake --build ... --target update_pictures" stores them there.
#include "windowtest.h"

namespace nmc {
namespace {

/// Each widget, and the file of its picture.
const QMap<QString, QString> kPictures{{u"panelHead"_s, u"head.png"_s},
                                       {u"motionBox"_s, u"motion.png"_s},
                                       {u"gainsBox"_s, u"gains.png"_s},
                                       {u"homingBox"_s, u"homing.png"_s}};

TEST(StoredPictures, AreThoseThatAreTaken) {
    QStringList stored = QDir(QStringLiteral(MANUAL_DIR "/pictures")).entryList({u"*.png"_s}, QDir::Files);
    QStringList taken = kPictures.values();
    stored.sort();
    taken.sort();
    EXPECT_EQ(stored, taken) << "build the target update_pictures";
}

class Pictures : public WindowTest {};

TEST_F(Pictures, AreTaken) {
    window->resize(1456, 1400);
    Servo servo{.position = 12'345};
    servo.held = true;
    showServo(servo);
    const QDir folder(QStringLiteral(PICTURE_DIR));
    ASSERT_TRUE(QDir().mkpath(folder.path()));
    for (auto picture = kPictures.cbegin(); picture != kPictures.cend(); ++picture) {
        QWidget* shown = find(picture.key());
        QApplication::processEvents();
        const QString file = folder.filePath(picture.value());
        ASSERT_TRUE(shown->grab().save(file));
        EXPECT_LT(QFileInfo(file).size(), 100'000) << file.toStdString();
    }
}

}  // namespace
}  // namespace nmc
