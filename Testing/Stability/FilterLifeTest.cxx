// SPDX-License-Identifier: BSD-3-Clause
// Aborts and deletions at every stage of an execution.
#include "FilterTools.h"

#include "vtkCommand.h"
#include "vtkPointData.h"
#include "vtkPolyDataNormals.h"

#include <functional>

namespace
{

/// Does something at one progress event.
class AtEvent : public vtkCommand
{
public:
  static AtEvent* New() { return new AtEvent; }

  void Execute(vtkObject*, unsigned long, void*) override
  {
    if (this->Seen++ == this->Number && this->Action)
    {
      this->Action();
    }
  }

  int Number = 0;
  int Seen = 0;
  std::function<void()> Action;
};

class FilterLife : public FilterTest
{
protected:
  FilterLife()
    : FilterTest("an abort or a deletion at any stage: a hang, a crash, a map of nothing")
  {
  }

  void SetUp() override
  {
    this->FilterTest::SetUp();
    this->Filter->SetPhotons(4000000000LL); // many minutes, unless the abort comes through
    this->Filter->AddObserver(vtkCommand::ProgressEvent, this->Watch);
  }

  std::string FieldText(const char* name) { return ::FieldText(this->Filter->GetOutput(), name); }

  vtkNew<AtEvent> Watch;
};

struct FilterDeletion : public ::testing::Test
{
  void SetUp() override
  {
    RecordProperty("protects", "a filter deleted while something still uses it or its output");
  }
};

} // namespace

TEST_F(FilterLife, AbortAtAnyStageLeavesAMapOfWhatWasTraced)
{
  this->Watch->Action = [&] { this->Filter->SetAbortExecute(1); };
  for (const int event : { 0, 1, 2, 5 }) // VTK's own, before the scene is built, while tracing
  {
    SCOPED_TRACE(event);
    this->Watch->Number = event;
    this->Watch->Seen = 0;
    this->Filter->SetAbortExecute(0);
    this->ExpectMap();
    EXPECT_EQ(this->FieldText("StoppedBy"), "abort\n");
    // Two more at most: "building the scene", which is not interrupted, and VTK's own at the end.
    EXPECT_LE(this->Watch->Seen, event + 3) << "it goes on after the abort";
  }
  this->Watch->Action = nullptr;
  this->Filter->SetAbortExecute(0);
  this->Filter->SetPhotons(4096);
  this->ExpectMap();
  EXPECT_EQ(this->FieldText("StoppedBy"), "photon limit\n");
  EXPECT_EQ(this->FieldText("PhotonsEmitted"), "4096\n") << "nothing is left of the aborted runs";
}

TEST_F(FilterLife, InputMayBeDeletedWhileItIsTraced)
{
  this->Watch->Number = 2;
  this->Watch->Action = [&]
  {
    this->Surface = nullptr;
    this->Filter->RemoveAllInputs();
    this->Filter->SetAbortExecute(1);
  };
  this->Run();
  EXPECT_EQ(this->Messages->Errors, 0) << this->Messages->Text;
}

TEST_F(FilterDeletion, MayComeFromItsOwnProgress)
{
  auto* filter = vtkIlluminationMap::New();
  filter->SetInputData(SmallSphere());
  filter->SetPhotons(1000000);
  vtkNew<AtEvent> watch;
  watch->Number = 1;
  watch->Action = [&] { filter->Delete(); };
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  filter->Update();
  EXPECT_GT(watch->Seen, 1);
}

TEST_F(FilterDeletion, MayFollowAnAbort)
{
  auto filter = vtkSmartPointer<vtkIlluminationMap>::New();
  filter->SetInputData(SmallSphere());
  filter->SetPhotons(4000000000LL);
  vtkNew<AtEvent> watch;
  watch->Number = 3;
  watch->Action = [&] { filter->SetAbortExecute(1); };
  filter->AddObserver(vtkCommand::ProgressEvent, watch);
  filter->Update();
  vtkSmartPointer<vtkPolyData> output = filter->GetOutput();
  filter = nullptr; // with the run that it keeps
  EXPECT_TRUE(AllFinite(output));
}

TEST_F(FilterDeletion, OfTheFilterLeavesThePipelineAfterIt)
{
  vtkNew<vtkPolyDataNormals> after;
  {
    vtkNew<vtkIlluminationMap> filter;
    filter->SetInputData(SmallSphere());
    filter->SetPhotons(4096);
    after->SetInputConnection(filter->GetOutputPort());
  }
  after->Update();
  EXPECT_NE(after->GetOutput()->GetPointData()->GetArray("Illuminance"), nullptr);
}
