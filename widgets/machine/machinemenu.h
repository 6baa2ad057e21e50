// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QStringList>
#include <functional>

#include "widgets/machine/differencesdialog.h"

class QAction;
class QMenu;

namespace nmc {

struct FileQuestion;

/// What the window shows about the machine and its file.
struct MachineFile {
    QString path;  ///< empty: there is no file yet
    QString name;  ///< the name of the machine; may be empty
    bool modified = false;
    QStringList recent;   ///< paths, the latest first
    bool saving = false;  ///< it is being written to the disk

    /// The name for the user: that of the file if there is one, otherwise that of the machine; may be empty.
    [[nodiscard]] QString title() const;
};

/// The machine's part of the File menu, and its dialogs. It asks the user before unsaved changes are lost;
/// all other requests are signals.
class MachineMenu : public QObject {
    Q_OBJECT

public:
    explicit MachineMenu(QWidget* window);

    void addTo(QMenu& menu);
    /// `locked`: operator mode, in which the machine cannot be changed.
    void setLocked(bool locked);
    /// Emits shown(). If a save has just succeeded, also continues what was waiting for it.
    void showFile(const MachineFile& file);
    [[nodiscard]] const MachineFile& file() const { return m_file; }
    /// The part of the window title after the program's name; "[*]" is the place of the modified mark.
    [[nodiscard]] QString titlePart() const;

    /// Opens the table of differences, or replaces what it shows.
    void showDifferences(const QString& file, std::vector<Difference> differences);
    void showCopy(ModuleIndex from, std::vector<Difference> differences);
    void closeDifferences();
    [[nodiscard]] DifferencesDialog* differences() const { return m_differences; }

    /// Calls `close` once the file has been saved, or if the user leaves unsaved changes for the next start.
    void askBeforeClose(const std::function<void()>& close);

signals:
    void newRequested();
    void openRequested(const QString& path);
    /// The receiver answers with showFile(): before this returns, to report that the file is being saved, and
    /// later to report the result.
    void saveRequested();
    void saveAsRequested(const QString& path);
    void applyRequested(const std::vector<nmc::PartId>& chosen);
    void differencesDropped();
    void shown();

private:
    using Go = std::function<void()>;
    /// Opens it unless it is open.
    DifferencesDialog& openDifferences();
    void fillRecent();
    void refresh();
    /// Calls `go` at once if nothing is unsaved; otherwise asks first.
    void askFirst(const Go& go);
    void ask(const QString& saveText, const QString& goOnText, const Go& go);
    void save(const Go& then);
    /// Saves to `path`; empty: to the present file.
    void save(const QString& path, const Go& then);
    void goOnAfterSaving();
    void waitForSave(const Go& close);
    void chooseToOpen();
    void chooseToSave(const Go& then);
    [[nodiscard]] FileQuestion fileQuestion(const QString& objectName, const QString& title) const;

    QWidget* m_window;
    MachineFile m_file;
    bool m_locked = false;
    Go m_afterSaving;    ///< called if saving succeeds
    Go m_afterChoosing;  ///< the same for the file that is being chosen
    QAction* m_new;
    QAction* m_open;
    QAction* m_save;
    QAction* m_saveAs;
    QMenu* m_recent;
    QPointer<DifferencesDialog> m_differences;
};

}  // namespace nmc
