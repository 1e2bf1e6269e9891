/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "vtkSeries.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "Time.H"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Hand an array to VTK without copying it
template<class VtkArray, class List>
void addArray
(
    vtkPointData* data,
    const char* name,
    const List& values,
    const int nComponents
)
{
    typedef typename VtkArray::ValueType number;

    vtkNew<VtkArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(nComponents);
    array->SetArray
    (
        const_cast<number*>(reinterpret_cast<const number*>(values.cdata())),
        vtkIdType(nComponents)*values.size(),
        1       // VTK must not delete it
    );
    data->AddArray(array);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::vtkSeries::vtkSeries(const fileName& path, const word& name)
:
    path_(path),
    name_(name)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::vtkSeries::resume(const scalar time)
{
    if (!Pstream::master())
    {
        return;
    }

    std::ifstream is(path_/(name_ + ".pvd"));
    std::string line;
    const std::string key("timestep=\"");

    while (std::getline(is, line))
    {
        const size_t at = line.find(key);
        if (at == std::string::npos)
        {
            continue;
        }
        const scalar t =
            std::strtod(line.c_str() + at + key.size(), nullptr);

        if (t < time*(1 - 1e-9))
        {
            times_.append(t);
            lines_.append(line);
        }
    }
}


void Foam::dew::vtkSeries::write
(
    const Time& time,
    const particleState& s,
    const std::vector<column>& further
)
{
    const vtkIdType n = s.size();

    vtkNew<vtkDoubleArray> x;
    x->SetNumberOfComponents(3);
    if (n)
    {
        x->SetArray
        (
            const_cast<double*>(reinterpret_cast<const double*>(s.x.cdata())),
            3*n, 1
        );
    }

    vtkNew<vtkPoints> points;
    points->SetData(x);

    vtkNew<vtkCellArray> vertices;
    for (vtkIdType i = 0; i < n; i++)
    {
        vertices->InsertNextCell(1, &i);
    }

    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetVerts(vertices);

    if (n)
    {
        vtkPointData* values = data->GetPointData();
        addArray<vtkIntArray>(values, "id", s.id, 1);
        addArray<vtkIntArray>(values, "typeId", s.type, 1);
        addArray<vtkDoubleArray>(values, "d", s.d, 1);
        addArray<vtkDoubleArray>(values, "U", s.v, 3);
        addArray<vtkDoubleArray>(values, "omega", s.omega, 3);
        if (s.thermal)
        {
            addArray<vtkDoubleArray>(values, "T", s.T, 1);
        }
        for (const column& c : further)
        {
            addArray<vtkDoubleArray>(values, c.name.c_str(), c.values, 1);
        }
    }

    const auto file = [&](const label rank)
    {
        return
            name_ + '/' + name_ + '_' + time.timeName()
          + (Pstream::parRun() ? "_" + Foam::name(rank) : "") + ".vtp";
    };

    mkDir(path_/name_);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName((path_/file(Pstream::myProcNo())).c_str());
    writer->SetInputData(data);
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToNone();
    if (!writer->Write())
    {
        FatalErrorInFunction
            << "Cannot write " << path_/file(Pstream::myProcNo())
            << exit(FatalError);
    }

    if (!Pstream::master())
    {
        return;
    }

    for (label rank = 0; rank < Pstream::nProcs(); rank++)
    {
        std::ostringstream os;
        os.precision(12);
        os  << "    <DataSet timestep=\"" << time.value() << "\" part=\""
            << rank << "\" file=\"" << file(rank) << "\"/>";
        times_.append(time.value());
        lines_.append(os.str());
    }

    std::ofstream os(path_/(name_ + ".pvd"));
    os  << "<?xml version=\"1.0\"?>\n"
        << "<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n";
    for (const std::string& line : lines_)
    {
        os << line << '\n';
    }
    os << "  </Collection>\n</VTKFile>\n";
}
