/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fvMesh.H"
#include "syncTools.H"

template<class Type>
void Foam::dew::cellLinks::fetch
(
    const fvMesh& mesh,
    const UList<Type>& values,
    List<Type>& behind
)
{
    behind.setSize(mesh.nBoundaryFaces());

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.coupled())
        {
            const labelUList& cells = patch.faceCells();
            const label first = patch.start() - mesh.nInternalFaces();
            forAll(cells, i)
            {
                behind[first + i] = values[cells[i]];
            }
        }
    }
    syncTools::swapBoundaryFaceList(mesh, behind);
}
