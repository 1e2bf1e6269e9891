/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fileInsertion.H"
#include "addToRunTimeSelectionTable.H"
#include "PstreamReduceOps.H"
#include "Time.H"
#include "userEntry.H"

#include <charconv>
#include <cmath>
#include <sstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace insertionModels
{
    defineTypeName(fileInsertion);
    addToRunTimeSelectionTable(insertionModel, fileInsertion, dictionary);
}
}
}

namespace
{

std::vector<std::string> fields(std::string line)
{
    for (char& c : line)
    {
        if (c == ',' || c == ';' || c == '\r')
        {
            c = ' ';
        }
    }

    std::istringstream is(line);
    std::vector<std::string> result;
    std::string one;
    while (is >> one)
    {
        result.push_back(one);
    }
    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::insertionModels::fileInsertion::fileInsertion
(
    const word& name,
    const dictionary& dict,
    const materials& mats,
    const particleBox& box,
    const Time& time
)
:
    insertionModel(name, dict, mats, box, time, false),
    path_(dict.get<fileName>("file")),
    line_(0),
    minD_(GREAT),
    maxD_(0)
{
    userEntry::onlyThese
    (
        dict, {"type", "file", "material", "velocity", "omega", "T"}
    );

    path_.expand();
    if (!path_.isAbsolute())
    {
        path_ = time.globalPath()/path_;
    }

    if (Pstream::master())
    {
        open();
        particleList all;
        while (readLine(all))
        {
            minD_ = min(minD_, all.d.last());
            maxD_ = max(maxD_, all.d.last());
            all.clear();
        }
        if (maxD_ <= 0)
        {
            FatalIOErrorInFunction(dict)
                << "No particle in file " << path_ << exit(FatalIOError);
        }
        open();
    }
    reduce(minD_, minOp<scalar>());
    reduce(maxD_, maxOp<scalar>());
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::insertionModels::fileInsertion::bad(const std::string& what) const
{
    FatalIOErrorInFunction(dict_)
        << "File " << path_ << ", line " << line_ << ": " << what.c_str() << nl
        << "Expected columns: x y z d [vx vy vz] [wx wy wz] [T] [material],"
        << " named in the first line, values in SI"
        << exit(FatalIOError);

    ::abort();      // never reached: exit() ends the run
}


void Foam::dew::insertionModels::fileInsertion::open()
{
    static const char* known[] =
    {
        "x", "y", "z", "d", "vx", "vy", "vz", "wx", "wy", "wz", "T", "material",
        "id"
    };

    is_.close();
    is_.clear();
    is_.open(path_);
    line_ = 0;

    if (!is_.good())
    {
        FatalIOErrorInFunction(dict_)
            << "Cannot open file " << path_ << " of entry 'file'" << nl
            << "The path counts from the case"
            << exit(FatalIOError);
    }

    std::string text;
    while (std::getline(is_, text))
    {
        line_++;
        columns_ = fields(text);
        if (columns_.size() && columns_[0][0] != '#')
        {
            break;
        }
    }

    for (const std::string& c : columns_)
    {
        bool valid = false;
        for (const char* k : known)
        {
            valid = valid || c == k;
        }
        if (!valid)
        {
            bad("unknown column " + c);
        }
    }

    for (label i = 0; i < 4; i++)
    {
        if (std::find(columns_.begin(), columns_.end(), known[i]) == columns_.end())
        {
            bad(std::string("no column ") + known[i]);
        }
    }
}


bool Foam::dew::insertionModels::fileInsertion::readLine(particleList& list)
{
    std::string text;
    std::vector<std::string> value;

    while (value.empty() || value[0][0] == '#')
    {
        if (!std::getline(is_, text))
        {
            return false;
        }
        line_++;
        value = fields(text);
    }

    if (value.size() != columns_.size())
    {
        bad
        (
            std::to_string(value.size()) + " values for "
          + std::to_string(columns_.size()) + " columns"
        );
    }

    point x(Zero);
    vector v(velocity_), w(omega_);
    scalar d = 0, T = T_;
    label type = material_;

    for (size_t c = 0; c < columns_.size(); c++)
    {
        const std::string& key = columns_[c];

        if (key == "id")
        {
            continue;
        }
        if (key == "material")
        {
            type = materials_.names().find(word(value[c], false));
            if (type < 0)
            {
                std::string known;
                for (const word& name : materials_.names())
                {
                    known += ' ' + name;
                }
                bad("unknown material " + value[c] + "; known are" + known);
            }
            continue;
        }

        // Not strtod: an overflow would end in a signal
        scalar number = 0;
        const char* begin = value[c].c_str() + (value[c][0] == '+');
        const char* end = value[c].c_str() + value[c].size();
        const auto read = std::from_chars(begin, end, number);

        if
        (
            read.ec != std::errc() || read.ptr != end
         || !std::isfinite(number)
        )
        {
            bad("'" + value[c] + "' in column " + key + " is no finite number");
        }

        if (key == "d")
        {
            d = number;
            if (!(d > 0))
            {
                bad("diameter " + value[c] + " is not greater than zero");
            }
        }
        else if (key == "T")
        {
            T = number;
        }
        else
        {
            vector& to = key.size() == 1 ? x : key[0] == 'v' ? v : w;
            to[key.back() - 'x'] = number;
        }
    }

    if (type < 0)
    {
        bad("no material: add a column or the entry 'material'");
    }

    list.append(type, x, v, w, d, T);

    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::insertionModels::fileInsertion::initial(particleList& chunk)
{
    chunk.clear();

    if (Pstream::master())
    {
        while (chunk.size() < particleList::chunk && readLine(chunk))
        {}
    }
    chunk.scatter();

    return chunk.size() > 0;
}
