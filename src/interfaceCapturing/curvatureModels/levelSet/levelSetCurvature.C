/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "levelSetCurvature.H"
#include "addToRunTimeSelectionTable.H"
#include "transportedSurface.H"
#include "userEntry.H"
#include "wallContact.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace curvatureModels
{
    defineTypeName(levelSet);
    addToRunTimeSelectionTable(curvatureModel, levelSet, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::curvatureModels::levelSet::levelSet
(
    const transportedSurface& surface,
    const dictionary& dict
)
:
    curvatureModel(surface),
    symmetry_(surface.mesh()),
    cells_(surface.mesh())
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tensor Foam::dew::curvatureModels::levelSet::gradientOfNormal
(
    const label i,
    const UList<vector>& behind
) const
{
    const label celli = cells_.cell()[i];
    const vectorField& n = surface_.n().primitiveField();

    const scalar psi = surface_.psi()[celli];
    tensor gradn(Zero);

    // The normal at a contact line needs gradn
    bool atContact = false;
    for (label step = 0; step == 0 || (atContact && step < 10); step++)
    {
        const tensor old(gradn);
        gradn = Zero;
        for (const cellLinks::link& l : cells_.of(i))
        {
            if (l.patch == cellLinks::unknown)
            {
                continue;
            }
            const vector other
            (
                l.patch >= 0
              ? wallContact::normal(surface_, l, psi, n[celli], old)
              : l.cell >= 0 ? n[l.cell]
              : behind[-1 - l.cell]
            );
            gradn += l.w*(other - n[celli]);
            atContact = atContact || l.patch >= 0;
        }
    }
    if (symmetry_.wedge())
    {
        const vector toC(surface_.mesh().C()[celli] - symmetry_.origin());
        gradn +=
            (n[celli] & symmetry_.radial())/(toC & symmetry_.radial())
           *(symmetry_.azimuth()*symmetry_.azimuth());
    }
    return gradn;
}


// * * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * //

void Foam::dew::curvatureModels::levelSet::calculate
(
    scalarField& K,
    boolList& known
)
{
    const fvMesh& mesh = surface_.mesh();
    const List<labelPair> pairs(wallContact::betweenFaces(surface_));

    DynamicList<label> cells(surface_.planes().cell());
    for (const labelPair& pair : pairs)
    {
        cells.append(pair.first());
    }

    const vectorField& n = surface_.n().primitiveField();
    labelList usable(mesh.nCells(), -1);
    forAll(n, celli)
    {
        usable[celli] = n[celli] == vector(Zero) ? -1 : 0;
    }
    cells_.set(cells, usable, wallContact::faces(surface_, pairs, 2));

    List<vector> behind;
    cellLinks::fetch(mesh, n, behind);

    forAll(cells, i)
    {
        const label celli = cells[i];
        const tensor gradn(gradientOfNormal(i, behind));
        const scalar psi = surface_.psi()[celli];
        const scalar k = tr(gradn);
        const scalar G = 0.5*(sqr(k) - (gradn && gradn.T()));
        const scalar spread = 1 + psi*k + sqr(psi)*G;

        known[celli] = usable[celli] == 0 && spread > 0;
        K[celli] = known[celli] ? (k + 2*psi*G)/spread : 0;
    }
}
