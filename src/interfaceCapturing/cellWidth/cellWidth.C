/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cellWidth.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(cellWidth, 0);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::cellWidth::cellWidth(const fvMesh& mesh)
:
    MeshObject<fvMesh, GeometricMeshObject, cellWidth>(mesh),
    width_(mesh.nCells())
{
    const vectorField& Sf = mesh.faceAreas();
    const scalarField& V = mesh.cellVolumes();
    const Vector<label>& directions = mesh.geometricD();

    forAll(width_, celli)
    {
        vector area(Zero);
        for (const label facei : mesh.cells()[celli])
        {
            area += 0.5*cmptMag(Sf[facei]);
        }
        scalar product = 1;
        for (direction i = 0; i < vector::nComponents; i++)
        {
            if (directions[i] > 0)
            {
                product *= V[celli]/area[i];
            }
        }
        width_[celli] = Foam::pow(product, 1.0/mesh.nGeometricD());
    }
}
