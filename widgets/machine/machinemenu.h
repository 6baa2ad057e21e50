// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <functional>

#include "widgets/machine/differencesdialog.h"

class QAction;
class QFileDialog;
class QMenu;

namespace nmc {

/// What the window says of the machine and its file.
struct MachineFile {
    QString path;  ///< empty: it has none yet
    QString name;  ///< of the machine; may be empty
    bool modified = false;
    QStringList recent;   ///< paths, the latest first
    bool saving = false;  ///< the disk has not answered yet

    /// What a user calls it: its file's name, or its own; may be empty.
    [[nodiscard]] QString title() const;
};

/// The machine's part of the File menu, and the dialogs that follow from it. It asks before unsaved work
/// gives way; everything else is asked for by signals.
class MachineMenu : public QObject {
    Q_OBJECT

public:
    explicit MachineMenu(QWidget* window);

    void addTo(QMenu& menu);
    /// In operator mode the machine stays as it is.
    void setLocked(bool locked);
    /// Emits shown() only.
    void showFile(const MachineFile& file);
    [[nodiscard]] const MachineFile& file() const { return m_file; }
    /// What stands behind the program's name in the title; "[*]" is the place of the modified mark.
    [[nodiscard]] QString titlePart() const;

    /// Opens the table of differences, or replaces what it shows.
    void showDifferences(const QString& file, std::vector<Difference> differences);
    void closeDifferences();
    [[nodiscard]] DifferencesDialog* differences() const { return m_differences; }

    /// Calls `close` when the file is saved, or the user says that the work may wait for the next start.
    void askBeforeClose(const std::function<void()>& close);

signals:
    void newRequested();
    void openRequested(const QString& path);
    /// Answered by showFile(): before this returns that it is being saved, and then what became of it.
    void saveRequested();
    void saveAsRequested(const QString& path);
    void applyRequested(const std::vector<nmc::PartId>& chosen);
    void differencesDropped();
    void shown();

private:
    using Go = std::function<void()>;
    QAction* newAction(const QString& objectName, const QString& text, const QKeySequence& shortcut,
                       const QString& tip);
    void fillRecent();
    void refresh();
    /// Calls `go` at once when nothing is unsaved.
    void askFirst(const Go& go);
    void ask(const QString& saveText, const QString& goOnText, const Go& go);
    void save(const Go& then);
    /// To that file; empty: the one that it has.
    void save(const QString& path, const Go& then);
    void goOnAfterSaving();
    void waitForSave(const Go& close);
    void chooseToOpen();
    void chooseToSave(const Go& then);
    QFileDialog* newMachineDialog(const QString& objectName, const QString& title);

    QWidget* m_window;
    MachineFile m_file;
    bool m_locked = false;
    Go m_afterSaving;  ///< if it works
    QAction* m_new;
    QAction* m_open;
    QAction* m_save;
    QAction* m_saveAs;
    QMenu* m_recent;
    QPointer<DifferencesDialog> m_differences;
};

}  // namespace nmc
