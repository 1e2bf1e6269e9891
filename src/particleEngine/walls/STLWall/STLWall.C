/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "STLWall.H"
#include "addToRunTimeSelectionTable.H"
#include "OSspecific.H"
#include "polyMesh.H"
#include "Time.H"
#include "triSurface.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace walls
{
    defineTypeName(STLWall);
    addToRunTimeSelectionTable(particleWall, STLWall, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::walls::STLWall::STLWall
(
    const word& name,
    const dictionary& dict,
    const materials& mats,
    const polyMesh& mesh
)
:
    particleWall(name, dict, mats, mesh),
    path_(dict.get<fileName>("file")),
    scale_(userEntry::positiveOr(dict, "scale", dimless, 1))
{
    userEntry::onlyThese
    (
        dict, {"type", "file", "scale", "material", "motion", "T"}
    );

    path_.expand();
    if (!path_.isAbsolute())
    {
        path_ = mesh.time().globalPath()/path_;
    }

    if (Pstream::master() && !isFile(path_))
    {
        FatalIOErrorInFunction(dict)
            << "No file " << path_ << " (entry 'file' of wall " << name << ')'
            << nl << "The path counts from the case"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::dew::wallShape>
Foam::dew::walls::STLWall::shapes() const
{
    wallShape result;

    if (Pstream::master())
    {
        // OpenFOAM's reader does not say whose file it is
        const bool throwing = FatalError.throwExceptions();
        const bool throwingIO = FatalIOError.throwExceptions();
        triSurface surface;
        std::string problem;
        try
        {
            surface = triSurface(path_);
        }
        catch (const error& e)
        {
            problem = e.message();
        }
        FatalError.throwExceptions(throwing);
        FatalIOError.throwExceptions(throwingIO);

        if (surface.empty())
        {
            FatalIOErrorInFunction(dict_)
                << "No triangle in file " << path_ << " (entry 'file' of wall "
                << name_ << "): " << problem.c_str() << nl
                << "Give a surface that OpenFOAM's surfaceCheck can read"
                << exit(FatalIOError);
        }

        for (const labelledTri& t : surface)
        {
            for (const label pointi : t)
            {
                result.corners.append(scale_*surface.points()[pointi]);
            }
        }
    }

    return List<wallShape>(1, result);
}
