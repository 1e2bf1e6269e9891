/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cellKernel.H"
#include "emptyPolyPatch.H"
#include "polyMesh.H"
#include "SubField.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::cellKernel::cellKernel(const polyMesh& mesh)
:
    plane_(vector::one),
    mesh_(mesh)
{
    for (direction k = 0; k < 3; k++)
    {
        if (mesh.geometricD()[k] < 0)
        {
            plane_[k] = 0;
        }
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::dew::cellKernel::widths() const
{
    scalarField width(cbrt(mesh_.cellVolumes()));
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch) || isA<wedgePolyPatch>(patch))
        {
            forAll(patch, i)
            {
                // On an axis they have none
                const scalar area = mag(patch.faceAreas()[i]);
                if (area > VSMALL)
                {
                    width[patch.faceCells()[i]] = std::sqrt(area);
                }
            }
        }
    }
    return width;
}
