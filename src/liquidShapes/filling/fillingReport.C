/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "filling.H"
#include "polyMesh.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::dew::filling::fillsBounds() const
{
    const scalar held = symmetry_.ringFactor()*gSum(mesh_.cellVolumes());
    const boundBox bounds
    (
        symmetry_.wedge() ? symmetry_.bounds() : mesh_.bounds()
    );
    scalar whole = cmptProduct(bounds.span());
    if (symmetry_.wedge())
    {
        whole *= 0.25*constant::mathematical::pi;
    }
    return mag(held - whole) <= 1e-9*whole;
}


Foam::scalar Foam::dew::filling::byFormula
(
    const label shapei,
    const bool fillsBounds
) const
{
    const liquidShape& shape = shapes_[shapei];
    scalar V = -1;
    if (fillsBounds)
    {
        V = shape.volume
        (
            symmetry_.wedge() ? symmetry_.bounds() : mesh_.bounds()
        );
    }
    if (V < 0 && atBoundary_[shapei] <= 1e-13*held_[shapei])
    {
        V = shape.volume();
    }
    return V/symmetry_.ringFactor();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::filling::report(Ostream& os) const
{
    const bool fills = fillsBounds();
    forAll(shapes_, i)
    {
        os  << "Shape " << names_[i] << ": " << held_[i] << " m3 in the mesh";

        const scalar V = byFormula(i, fills);
        if (V <= 0)
        {
            os  << ", no formula: it goes beyond the mesh" << endl;
            continue;
        }
        const scalar error = held_[i]/V - 1;
        os  << ", by formula " << V << " m3, relative difference "
            << error << endl;
        if (mag(error) > 1e-6)
        {
            WarningInFunction
                << "The shape " << names_[i] << " does not fit the mesh, by "
                << error << " of its volume: see its place, and checkMesh"
                << endl;
        }
    }

    const scalar held = gSum(scalarField(share_*mesh_.cellVolumes()));
    os  << "Liquid in the mesh " << held << " m3";
    if (symmetry_.wedge())
    {
        os  << ", in the whole ring " << symmetry_.ringFactor()*held << " m3";
    }
    os  << endl;
}
