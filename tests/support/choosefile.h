// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QListView>
#include <QMessageBox>
#include <QTest>
#include <QTimer>

namespace nmc::testing_support {

/// Types the whole path into the dialog and presses Return; an existing file may be replaced.
inline void chooseFile(QFileDialog& dialog, const QString& path) {
    auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    // What is typed takes the place of a selected file only in an active window.
    dialog.findChild<QListView*>(QStringLiteral("listView"))->clearSelection();
    name->setText(path);
    // The question whether to replace a file runs its own event loop.
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, &dialog, [&] {
        if (auto* question = dialog.findChild<QMessageBox*>())
            question->button(QMessageBox::Yes)->click();
    });
    answer.start(0);
    QTest::keyClick(name, Qt::Key_Return);
}

}  // namespace nmc::testing_support
