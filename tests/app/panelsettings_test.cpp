// SPDX-License-Identifier: GPL-3.0-or-later
// Settings beside a panel that was killed while it wrote them; in real time, because file times are.
#include "app/panelsettings.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include "tests/support/eventually.h"

namespace nmc {
namespace {

class KilledWhileWriting : public testing::Test {
protected:
    /// As a panel leaves it that is killed before the lock is complete.
    void leaveLock() const { EXPECT_TRUE(QFile(m_file + QStringLiteral(".lock")).open(QFile::WriteOnly)); }

    /// Not by QSettings, which would write first what this process has not written yet.
    [[nodiscard]] bool isWritten() const {
        QFile file(m_file);
        return file.open(QFile::ReadOnly) && file.readAll().contains("speed=4");
    }
    QTemporaryDir m_folder;
    QString m_file = m_folder.filePath(QStringLiteral("panel.ini"));
};

/// QSettings would wait for 30 s.
TEST_F(KilledWhileWriting, TheProgramEndsAllTheSame) {
    QElapsedTimer time;
    time.start();
    {
        PanelSettings settings(m_file);
        leaveLock();
        settings.setValue(QStringLiteral("speed"), QStringLiteral("4"));
    }
    EXPECT_LT(time.elapsed(), 15'000);
    EXPECT_TRUE(isWritten());
}

TEST_F(KilledWhileWriting, TheNextProgramStartsAllTheSame) {
    leaveLock();
    QElapsedTimer time;
    time.start();
    PanelSettings settings(m_file);
    settings.setValue(QStringLiteral("speed"), QStringLiteral("4"));
    settings.sync();
    EXPECT_LT(time.elapsed(), 15'000);
    EXPECT_TRUE(isWritten());
}

TEST_F(KilledWhileWriting, TheWindowDoesNotWaitForTheLock) {
    PanelSettings settings(m_file);
    leaveLock();
    settings.setValue(QStringLiteral("speed"), QStringLiteral("4"));
    QElapsedTimer time;
    time.start();
    QCoreApplication::sendPostedEvents(&settings);
    EXPECT_LT(time.elapsed(), 15'000);
    EXPECT_TRUE(testing_support::eventually([this] { return isWritten(); }));
}

/// Otherwise the panel would put writing off for ever, and say nothing.
TEST_F(KilledWhileWriting, APlaceThatCannotBeWrittenIsReported) {
    EXPECT_TRUE(QFile(m_file).open(QFile::WriteOnly));
    PanelSettings settings(m_file + QStringLiteral("/within-a-file.ini"));
    settings.setValue(QStringLiteral("speed"), QStringLiteral("4"));
    QCoreApplication::sendPostedEvents(&settings);
    EXPECT_EQ(settings.status(), QSettings::AccessError);
}

}  // namespace
}  // namespace nmc
