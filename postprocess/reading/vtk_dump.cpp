// Part of liggghts-ellipsoid. Licence: GPL-2.0-or-later.
#include "vtk_dump.h"

#include "legacy_vtk_check.h"
#include "quaternion_of_matrix.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <sys/stat.h>
#include <vtkDataArray.h>
#include <vtkDataSetReader.h>
#include <vtkLogger.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPUnstructuredGridReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

namespace ellipsoid::post {
namespace {

bool ends_with(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() &&
         text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/// VTK would print many lines of its own about a broken file; what it says is kept instead.
class KeptMessages : public vtkOutputWindow {
 public:
  static KeptMessages* New() { return new KeptMessages; }
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char* text) override {
    if (first_.empty())
      first_ = text;
  }
  /// The sentence of the first error, or nothing: "ERROR: In F, line L\nvtkClass (0x1): sentence".
  std::string first_error() const {
    const std::size_t object = first_.find("): ");
    const std::size_t begin = object == std::string::npos ? 0 : object + 3;
    std::string sentence = first_.substr(begin, first_.find('\n', begin) - begin);
    std::replace_if(
        sentence.begin(), sentence.end(), [](char letter) { return letter < ' ' || letter > '~'; },
        '?');
    return sentence;
  }

 private:
  std::string first_;
};

/// As long as it lives, messages of VTK go to `kept`.
class ListenToVtk {
 public:
  ListenToVtk()
      : kept(vtkSmartPointer<KeptMessages>::New()), before_(vtkOutputWindow::GetInstance()),
        verbosity_(vtkLogger::GetCurrentVerbosityCutoff()) {
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    vtkOutputWindow::SetInstance(kept);
  }
  ~ListenToVtk() {
    vtkOutputWindow::SetInstance(before_);
    vtkLogger::SetStderrVerbosity(verbosity_);
  }
  ListenToVtk(const ListenToVtk&) = delete;
  ListenToVtk& operator=(const ListenToVtk&) = delete;

  const vtkSmartPointer<KeptMessages> kept;

 private:
  const vtkSmartPointer<vtkOutputWindow> before_;
  const vtkLogger::Verbosity verbosity_;
};

template <class Reader> vtkSmartPointer<vtkPointSet> read_with(const std::string& path) {
  const auto reader = vtkSmartPointer<Reader>::New();
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0)
    return nullptr;
  return vtkPointSet::SafeDownCast(reader->GetOutputDataObject(0));
}

vtkSmartPointer<vtkPointSet> read_points(const std::string& path) {
  if (ends_with(path, ".pvtu"))
    return read_with<vtkXMLPUnstructuredGridReader>(path);
  if (ends_with(path, ".vtu"))
    return read_with<vtkXMLUnstructuredGridReader>(path);
  if (ends_with(path, ".vtp"))
    return read_with<vtkXMLPolyDataReader>(path);
  check_legacy_vtk(path);
  const auto reader = vtkSmartPointer<vtkDataSetReader>::New();
  reader->SetFileName(path.c_str());
  reader->ReadAllScalarsOn();
  reader->ReadAllVectorsOn();
  reader->ReadAllTensorsOn();
  reader->ReadAllFieldsOn();
  reader->Update();
  if (reader->GetErrorCode() != 0)
    return nullptr;
  return vtkPointSet::SafeDownCast(reader->GetOutputDataObject(0));
}

/// The last run of digits in a file's name as a number.
std::int64_t step_in(const std::string& path) {
  std::size_t end = path.size();
  const auto is_digit = [&](std::size_t k) {
    return std::isdigit(static_cast<unsigned char>(path[k])) != 0;
  };
  while (end > 0 && !is_digit(end - 1))
    --end;
  std::size_t begin = end;
  while (begin > 0 && is_digit(begin - 1))
    --begin;
  return std::strtoll(path.substr(begin, end - begin).c_str(), nullptr, 10);
}

/// Names of the columns that an array becomes.
std::vector<std::string> column_names(const std::string& name, int components) {
  if (components == 1)
    return {name};
  const bool is_short = components == 3 && name.find('[') == std::string::npos;
  std::vector<std::string> names;
  for (int k = 0; k < components; ++k)
    names.push_back(is_short ? name + "xyz"[k] : fmt::format("{}[{}]", name, k + 1));
  return names;
}

void add_column(Frame& frame, const std::string& name, std::vector<double> values) {
  frame.names.push_back(name);
  frame.unreadable.emplace_back();
  for (std::size_t row = 0; row < values.size(); ++row)
    if (!std::isfinite(values[row]) && frame.unreadable.back().empty())
      frame.unreadable.back() =
          fmt::format("{}: array \"{}\", point {}: expected a finite number, found {}",
                      frame.location.file, name, row, values[row]);
  frame.columns.push_back(std::move(values));
}

void add_quaternions(Frame& frame, vtkDataArray& array) {
  std::vector<double> parts[4];
  double m[9];
  for (vtkIdType row = 0; row < array.GetNumberOfTuples(); ++row) {
    array.GetTuple(row, m); // by rows; its columns are the body's axes
    const Quaternion q =
        quaternion_of({{m[0], m[3], m[6]}, {m[1], m[4], m[7]}, {m[2], m[5], m[8]}});
    parts[0].push_back(q.w);
    parts[1].push_back(q.x);
    parts[2].push_back(q.y);
    parts[3].push_back(q.z);
  }
  for (int k = 0; k < 4; ++k)
    add_column(frame, fmt::format("quat{}", k + 1), std::move(parts[k]));
}

void add_array(Frame& frame, vtkDataArray& array, const std::string& name) {
  if (static_cast<std::size_t>(array.GetNumberOfTuples()) != frame.rows)
    throw InputError(fmt::format("{}: array \"{}\": expected {} values, found {}",
                                 frame.location.file, name, frame.rows, array.GetNumberOfTuples()));
  const int components = array.GetNumberOfComponents();
  if (name == "TENSOR" && components == 9) {
    add_quaternions(frame, array);
    return;
  }
  const auto names = column_names(name, components);
  for (int k = 0; k < components; ++k) {
    std::vector<double> values(frame.rows);
    for (std::size_t row = 0; row < frame.rows; ++row)
      values[row] = array.GetComponent(static_cast<vtkIdType>(row), k);
    add_column(frame, names[static_cast<std::size_t>(k)], std::move(values));
  }
}

} // namespace

VtkDumpReader::VtkDumpReader(std::string path) : path_(std::move(path)) {
  struct stat status {};
  if (stat(path_.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
    throw InputError(path_ + ": cannot be opened");
  consumed_ = static_cast<std::uint64_t>(status.st_size);
}

bool VtkDumpReader::next(Frame& frame) {
  if (is_done_)
    return false;
  is_done_ = true;
  frame = Frame();
  frame.location = {path_, 1, 1};
  frame.timestep = step_in(path_);
  frame.label = "ATOMS";
  const ListenToVtk listening;
  const vtkSmartPointer<vtkPointSet> points = read_points(path_);
  const std::string error = listening.kept->first_error();
  if (!points || !error.empty())
    throw InputError(
        path_ +
        ": frame 1: expected a whole VTK file with points (PolyData or "
        "UnstructuredGrid), found " +
        (error.empty() ? "something else or a broken file" : "a broken file: " + error));
  frame.rows = static_cast<std::size_t>(points->GetNumberOfPoints());
  std::vector<double> coordinates[3];
  for (std::size_t row = 0; row < frame.rows; ++row)
    for (int k = 0; k < 3; ++k)
      coordinates[k].push_back(points->GetPoint(static_cast<vtkIdType>(row))[k]);
  for (int k = 0; k < 3; ++k)
    add_column(frame, std::string(1, "xyz"[k]), std::move(coordinates[k]));
  vtkPointData* data = points->GetPointData();
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
    if (vtkDataArray* array = data->GetArray(k); array && array->GetName())
      add_array(frame, *array, array->GetName());
  return true;
}

} // namespace ellipsoid::post
